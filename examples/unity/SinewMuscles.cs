// examples/unity/SinewMuscles.cs: moves the muscle joints of `sinew export --as helpers` in any pose. Unity 2021 or later.
//
// Goes on the root of the imported character. Importers drop the extras of skins, so `gltf` is the file's JSON: export
// hero.gltf and keep a copy of it as hero.json, a TextAsset. Nodes are found by name; names must be unique. UnityGLTF and
// glTFast turn the sign of x: it is turned back here, so that formulas (docs/muscles.md) and numbers (docs/export.md, "Line
// data") are those of the file. Runs after the animation, before rendering.
using System;
using System.Linq;
using UnityEngine;

[DefaultExecutionOrder(1000)]  // After what else moves bones in LateUpdate.
public class SinewMuscles : MonoBehaviour {
    public TextAsset gltf;
    [Range(0, 1)] public float flex;  // Added to every line's activation.

    [Serializable] public class File { public Node[] nodes; public Skin[] skins; }
    [Serializable] public class Node { public string name; }
    [Serializable] public class Skin { public Extras extras; }
    [Serializable] public class Extras { public Data sinew; }
    [Serializable] public class Data { public string joint_scale; public Line[] lines; }
    [Serializable] public class Line {
        public Place[] joints;
        public Place origin, insertion, via;
        public float size, length, rest, volume, depth, twist, @base, gain, full;
        public float[] tendons, limits, flex;
    }
    [Serializable] public class Place { public int node; public float[] at, point, frame, shift; }
    struct Contraction { public double belly, soft, activation, share; }

    static readonly Matrix4x4 Turn = Matrix4x4.Scale(new Vector3(-1, 1, 1));
    Transform[] nodes;
    Data[] data;

    void Awake() {
        var file = JsonUtility.FromJson<File>(gltf.text);
        var named = GetComponentsInChildren<Transform>(true).ToLookup(t => t.name);
        nodes = file.nodes.Select(n => n.name == null ? null : named[n.name].FirstOrDefault()).ToArray();
        data = file.skins.Where(s => s.extras?.sinew?.lines != null).Select(s => s.extras.sinew).ToArray();
    }

    void LateUpdate() {
        foreach (var d in data)
            foreach (var line in d.lines) Pose(line, d.joint_scale);
    }

    static Vector3 V(float[] list, int from = 0) => new Vector3(list[from], list[from + 1], list[from + 2]);
    static double Clamped(double v) => Math.Min(Math.Max(v, 0), 1);
    static Matrix4x4 World(Transform t) => t == null ? Matrix4x4.identity : Turn * t.localToWorldMatrix * Turn;
    static Matrix4x4 Columns(Vector3 x, Vector3 y, Vector3 z, Vector3 place) =>
        new Matrix4x4(x, y, z, new Vector4(place.x, place.y, place.z, 1));

    // The line's bind frame as a bone carries it: the nearest rotation (Higham), and how much the bone has grown.
    static Vector3[] Carried(Matrix4x4 bone, float[] frame, out double growth) {
        var m = new[] { 0, 3, 6 }.Select(i => bone.MultiplyVector(V(frame, i))).ToArray();
        double volume = Vector3.Dot(m[0], Vector3.Cross(m[1], m[2]));
        double size = growth = Math.Pow(Math.Abs(volume), 1.0 / 3);
        m = m.Select(axis => axis / (float)(volume < 0 ? -size : size)).ToArray();
        for (int round = 0; round < 12; ++round) {
            var square = new[] { Vector3.Cross(m[1], m[2]), Vector3.Cross(m[2], m[0]), Vector3.Cross(m[0], m[1]) };
            float now = Vector3.Dot(m[0], square[0]);
            m = m.Select((axis, i) => (axis + square[i] / now) * 0.5f).ToArray();
        }
        return m;
    }

    // Belly stretch, its softened logarithm and activation at a stretch of the line.
    static Contraction Contract(Line line, double stretch, double flex) {
        double share = 1.0 - line.tendons[0] - line.tendons[1];
        double belly = Math.Max(stretch - 1 + share, 0.1 * share) / share;
        double x = Math.Log(belly), most = x < 0 ? -Math.Log(line.limits[0]) : Math.Log(line.limits[1]);
        double s = Clamped((1 - stretch) / (1 - line.full));
        return new Contraction { belly = belly, soft = most * Math.Tanh(x / most), share = share,
            activation = Clamped(line.@base + flex + line.gain * s * s * (3 - 2 * s)) };
    }

    // The height of a carried frame after the least turn that brings its direction onto the line.
    static Vector3 Swung(Vector3[] m, Vector3 direction) {
        float opening = 1 + Vector3.Dot(m[1], direction);
        return opening < 1e-6f ? m[2] : m[2] - (m[1] + direction) * (Vector3.Dot(m[2], direction) / opening);
    }

    // Between the heights a and b around the direction, as their quaternions mix.
    static Vector3 Mixed(Vector3 a, Vector3 b, Vector3 direction, double share) {
        var beside = Vector3.Cross(direction, a);
        double half = 0.5 * Math.Atan2(Vector3.Dot(beside, b), Vector3.Dot(a, b));
        double c = 1 - share + share * Math.Cos(half), s = share * Math.Sin(half);
        return (a * (float)(c * c - s * s) + beside * (float)(2 * c * s)) / (float)(c * c + s * s);
    }

    // How far the middle of the belly lies beside the straight line.
    static Vector3 ViaShift(Vector3 origin, Vector3 direction, Vector3 via, double tendon, double belly) {
        var there = via - origin;
        double foot = Vector3.Dot(there, direction), half = 0.5 * belly;
        double y = Math.Min(Math.Abs((foot - tendon - half) / half), 1), t = (1 - y) / 0.4;
        double fade = t * t * (10 - t * (15 - 6 * t));
        double factor = y < 0.6 ? 1 / (1 - y * y) : 1 + fade * y * y / (0.4 * (1 + y));
        var shift = (there - direction * (float)foot) * (float)factor;
        return shift.magnitude > half ? shift * (float)(half / shift.magnitude) : shift;
    }

    // Where a line's joints are.
    void Pose(Line line, string jointScale) {
        if (nodes[line.origin.node] == null || nodes[line.insertion.node] == null) return;
        Matrix4x4 from = World(nodes[line.origin.node]), to = World(nodes[line.insertion.node]);
        Vector3 origin = from.MultiplyPoint3x4(V(line.origin.point)), insertion = to.MultiplyPoint3x4(V(line.insertion.point));
        bool hasVia = line.via?.point?.Length == 3;
        var via = hasVia ? World(nodes[line.via.node]).MultiplyPoint3x4(V(line.via.point)) : origin;
        double growth, other;
        Vector3[] byOrigin = Carried(from, line.origin.frame, out growth), byInsertion = Carried(to, line.insertion.frame, out other);
        var along = insertion - origin;
        double straight = along.magnitude, size = Math.Sqrt(growth * other), rest = line.rest * line.length * size;
        double total = hasVia ? (via - origin).magnitude + (insertion - via).magnitude : straight;
        Contraction bind = Contract(line, 1 / line.rest, 0), now = Contract(line, total / rest, flex);
        var y = straight > 1e-6 * line.length ? along / (float)straight : byOrigin[1];
        var z = Mixed(Swung(byOrigin, y), Swung(byInsertion, y), y, line.twist);
        double girth = size * Math.Exp(-0.5 * line.volume * (now.soft - bind.soft));
        Func<float, float> thick = f => (float)(girth * (1 + f * now.activation) / (1 + f * bind.activation));
        Vector3 width = Vector3.Cross(y, z) * thick(line.flex[1]), height = z * thick(line.flex[0]);
        Vector3 belly = y * (float)(size * now.belly / bind.belly);
        double tendon = line.tendons[0] * rest;
        var start = origin + y * (float)tendon - z * (float)(size * line.depth);
        if (hasVia) {
            var shift = Columns(Vector3.Cross(y, z), y, z, Vector3.zero).MultiplyVector(V(line.via.shift));
            start += ViaShift(origin, y, via, tendon, now.belly * now.share * rest) - shift * (float)size;
        }
        foreach (var joint in line.joints) {
            var place = Columns(width, belly, height, start).MultiplyPoint3x4(V(joint.at));
            SetLocal(nodes[joint.node], Columns(width * line.size, belly * line.size, height * line.size, place), jointScale);
        }
    }

    // The same in its parent's space, as a joint can hold it. The second axis keeps its direction.
    static void SetLocal(Transform joint, Matrix4x4 world, string jointScale) {
        if (joint == null) return;
        var m = World(joint.parent).inverse * world;
        Vector3 x = m.GetColumn(0), y = m.GetColumn(1), z = m.GetColumn(2), up = Vector3.Cross(x, y);
        float even = (float)Math.Sqrt(x.magnitude * z.magnitude);
        if (!(even * y.magnitude < float.MaxValue) || up.magnitude == 0) return;  // A bone flattened to nothing.
        joint.localPosition = Turn.MultiplyPoint3x4(m.GetColumn(3));
        joint.localRotation = Quaternion.LookRotation(Turn.MultiplyVector(up), Turn.MultiplyVector(y));
        joint.localScale = jointScale == "none" ? Vector3.one : jointScale == "uniform" ? Vector3.one * even
            : new Vector3(x.magnitude, y.magnitude, z.magnitude);
    }
}
