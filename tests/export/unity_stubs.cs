// tests/export/unity_stubs.cs: what examples/unity/SinewMuscles.cs uses of Unity, and a program that poses by it.
// Usage: unity_stubs.exe FILE.gltf ORACLE.json; prints how many joints there were and how far apart, of H.
using System;
using System.Collections;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Reflection;

namespace UnityEngine {
    [AttributeUsage(AttributeTargets.Class)] public class DefaultExecutionOrder : Attribute { public DefaultExecutionOrder(int order) {} }
    [AttributeUsage(AttributeTargets.Field)] public class RangeAttribute : Attribute { public RangeAttribute(float least, float most) {} }

    public struct Vector4 {
        public float x, y, z, w;
        public Vector4(float x, float y, float z, float w) { this.x = x; this.y = y; this.z = z; this.w = w; }
        public static implicit operator Vector4(Vector3 v) => new Vector4(v.x, v.y, v.z, 0);
        public static implicit operator Vector3(Vector4 v) => new Vector3(v.x, v.y, v.z);
    }

    public struct Vector3 {
        public float x, y, z;
        public Vector3(float x, float y, float z) { this.x = x; this.y = y; this.z = z; }
        public static Vector3 zero => new Vector3(0, 0, 0);
        public static Vector3 one => new Vector3(1, 1, 1);
        public float magnitude => (float)Math.Sqrt(x * x + y * y + z * z);
        public static Vector3 operator +(Vector3 a, Vector3 b) => new Vector3(a.x + b.x, a.y + b.y, a.z + b.z);
        public static Vector3 operator -(Vector3 a, Vector3 b) => new Vector3(a.x - b.x, a.y - b.y, a.z - b.z);
        public static Vector3 operator *(Vector3 a, float t) => new Vector3(a.x * t, a.y * t, a.z * t);
        public static Vector3 operator /(Vector3 a, float t) => a * (1 / t);
        public static float Dot(Vector3 a, Vector3 b) => a.x * b.x + a.y * b.y + a.z * b.z;
        public static Vector3 Cross(Vector3 a, Vector3 b) =>
            new Vector3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
    }

    public struct Matrix4x4 {
        Vector4 x, y, z, w;
        public Matrix4x4(Vector4 x, Vector4 y, Vector4 z, Vector4 w) { this.x = x; this.y = y; this.z = z; this.w = w; }
        public Vector4 GetColumn(int i) => i == 0 ? x : i == 1 ? y : i == 2 ? z : w;
        public static Matrix4x4 identity => Scale(Vector3.one);
        public static Matrix4x4 Scale(Vector3 s) => new Matrix4x4(new Vector4(s.x, 0, 0, 0), new Vector4(0, s.y, 0, 0),
            new Vector4(0, 0, s.z, 0), new Vector4(0, 0, 0, 1));
        public Vector3 MultiplyVector(Vector3 v) => (Vector3)x * v.x + (Vector3)y * v.y + (Vector3)z * v.z;
        public Vector3 MultiplyPoint3x4(Vector3 v) => MultiplyVector(v) + w;
        public static Matrix4x4 operator *(Matrix4x4 a, Matrix4x4 b) {
            Vector4 place = a.MultiplyPoint3x4(b.w);
            place.w = 1;
            return new Matrix4x4(a.MultiplyVector(b.x), a.MultiplyVector(b.y), a.MultiplyVector(b.z), place);
        }
        public Matrix4x4 inverse { get {  // Affine matrices only.
            Vector3 p = Vector3.Cross(y, z), q = Vector3.Cross(z, x), r = Vector3.Cross(x, y);
            float volume = Vector3.Dot(x, p);
            var turned = new Matrix4x4(new Vector4(p.x, q.x, r.x, 0), new Vector4(p.y, q.y, r.y, 0), new Vector4(p.z, q.z, r.z, 0),
                new Vector4(0, 0, 0, 1));
            var linear = turned * Scale(Vector3.one);
            Func<Vector4, Vector4> part = v => (Vector3)v * (1 / volume);
            linear = new Matrix4x4(part(linear.x), part(linear.y), part(linear.z), new Vector4(0, 0, 0, 1));
            Vector4 place = linear.MultiplyVector(w) * -1;
            place.w = 1;
            return new Matrix4x4(linear.x, linear.y, linear.z, place);
        } }
    }

    /// Unity's are quaternions; this one keeps the axes, which is all that is asked.
    public struct Quaternion {
        public Vector3 x, y, z;
        public static Quaternion LookRotation(Vector3 forward, Vector3 upwards) {
            var z = forward / forward.magnitude;
            var x = Vector3.Cross(upwards, z);
            x = x / x.magnitude;
            return new Quaternion { x = x, y = Vector3.Cross(z, x), z = z };
        }
    }

    public class Transform {
        public string name;
        public Transform parent;
        public Matrix4x4 localToWorldMatrix;  // For bones, as the test sets it.
        public Vector3 localPosition, localScale;
        public Quaternion localRotation;
    }

    public class TextAsset { public string text; }

    public class MonoBehaviour {
        public List<Transform> below = new List<Transform>();
        public T[] GetComponentsInChildren<T>(bool inactive) => below.Cast<T>().ToArray();
    }

    /// As Unity's: public fields by name, what is not there stays away; no dictionaries.
    public static class JsonUtility {
        public static T FromJson<T>(string text) => (T)Made(typeof(T), new Json(text).Value());

        static object Made(Type type, object value) {
            if (value == null) return null;
            if (type == typeof(string)) return value as string;
            if (type.IsPrimitive) return Convert.ChangeType(value, type);
            if (type.IsArray) {
                var list = value as List<object>;
                if (list == null) return null;
                var array = Array.CreateInstance(type.GetElementType(), list.Count);
                for (int i = 0; i < list.Count; ++i) array.SetValue(Made(type.GetElementType(), list[i]), i);
                return array;
            }
            var members = value as Dictionary<string, object>;
            var made = Activator.CreateInstance(type);
            foreach (FieldInfo field in type.GetFields(BindingFlags.Public | BindingFlags.Instance)) {
                if (members != null && members.ContainsKey(field.Name)) field.SetValue(made, Made(field.FieldType, members[field.Name]));
            }
            return made;
        }
    }

    public class Json {
        readonly string text;
        int next;
        public Json(string text) { this.text = text; }

        char Skipped() { while (char.IsWhiteSpace(text[next])) ++next; return text[next]; }

        public object Value() {
            switch (Skipped()) {
                case '{': {
                    var members = new Dictionary<string, object>();
                    for (++next; Skipped() != '}';) {
                        if (text[next] == ',') { ++next; continue; }
                        var key = (string)Value();
                        Skipped();
                        ++next;
                        members[key] = Value();
                    }
                    ++next;
                    return members;
                }
                case '[': {
                    var list = new List<object>();
                    for (++next; Skipped() != ']';) {
                        if (text[next] == ',') { ++next; continue; }
                        list.Add(Value());
                    }
                    ++next;
                    return list;
                }
                case '"': {
                    var letters = new System.Text.StringBuilder();
                    for (++next; text[next] != '"'; ++next) {
                        if (text[next] == '\\') ++next;
                        letters.Append(text[next]);
                    }
                    ++next;
                    return letters.ToString();
                }
                default: {
                    int from = next;
                    while (next < text.Length && ",]} \n\r\t".IndexOf(text[next]) < 0) ++next;
                    var word = text.Substring(from, next - from);
                    if (word == "null") return null;
                    if (word == "true" || word == "false") return word == "true";
                    return double.Parse(word, CultureInfo.InvariantCulture);
                }
            }
        }
    }
}

static class Program {
    static UnityEngine.Matrix4x4 MatrixOf(object list) {
        var n = ((List<object>)list).Select(v => (float)(double)v).ToArray();
        return new UnityEngine.Matrix4x4(new UnityEngine.Vector4(n[0], n[1], n[2], 0), new UnityEngine.Vector4(n[4], n[5], n[6], 0),
            new UnityEngine.Vector4(n[8], n[9], n[10], 0), new UnityEngine.Vector4(n[12], n[13], n[14], 1));
    }

    static void Call(object on, string method) =>
        on.GetType().GetMethod(method, BindingFlags.Instance | BindingFlags.NonPublic).Invoke(on, null);

    static int Main(string[] words) {
        var text = System.IO.File.ReadAllText(words[0]);
        var file = (Dictionary<string, object>)new UnityEngine.Json(text).Value();
        var oracle = (Dictionary<string, object>)new UnityEngine.Json(System.IO.File.ReadAllText(words[1])).Value();
        var nodes = (List<object>)file["nodes"];
        var turn = UnityEngine.Matrix4x4.Scale(new UnityEngine.Vector3(-1, 1, 1));
        var muscles = new SinewMuscles { gltf = new UnityEngine.TextAsset { text = text } };
        foreach (Dictionary<string, object> node in nodes)
            muscles.below.Add(new UnityEngine.Transform { name = node.ContainsKey("name") ? (string)node["name"] : "" });
        for (int i = 0; i < nodes.Count; ++i) {
            var node = (Dictionary<string, object>)nodes[i];
            if (!node.ContainsKey("children")) continue;
            foreach (double child in (List<object>)node["children"]) muscles.below[(int)child].parent = muscles.below[i];
        }
        Call(muscles, "Awake");
        double height = (double)oracle["height"], worst = 0;
        int joints = 0;
        foreach (Dictionary<string, object> pose in (List<object>)oracle["poses"]) {
            foreach (var bone in (Dictionary<string, object>)pose["bones"])
                muscles.below[int.Parse(bone.Key)].localToWorldMatrix = turn * MatrixOf(bone.Value) * turn;
            var expected = (Dictionary<string, object>)pose["joints"];
            var moved = muscles.below.Where(t => expected.ContainsKey(t.name)).ToList();
            foreach (var joint in moved) joint.localScale = UnityEngine.Vector3.zero;
            muscles.flex = (float)(double)pose["flex"];
            Call(muscles, "LateUpdate");
            foreach (var joint in moved) {
                UnityEngine.Vector4 place = joint.localPosition;
                place.w = 1;
                var local = new UnityEngine.Matrix4x4(joint.localRotation.x * joint.localScale.x,
                    joint.localRotation.y * joint.localScale.y, joint.localRotation.z * joint.localScale.z, place);
                var found = turn * joint.parent.localToWorldMatrix * local * turn;
                var wanted = MatrixOf(expected[joint.name]);
                var size = ((UnityEngine.Vector3)wanted.GetColumn(1)).magnitude;
                double far = 0;
                foreach (var point in new[] { new UnityEngine.Vector3(0, 0, 0), new UnityEngine.Vector3(1, 0, 0),
                             new UnityEngine.Vector3(0, 1, 0), new UnityEngine.Vector3(0, 0, 1) }) {
                    var p = point * (float)(0.2 * height / size);
                    far = Math.Max(far, (found.MultiplyPoint3x4(p) - wanted.MultiplyPoint3x4(p)).magnitude / height);
                }
                worst = double.IsNaN(far) ? double.PositiveInfinity : Math.Max(worst, far);
                ++joints;
            }
        }
        Console.WriteLine(string.Format(CultureInfo.InvariantCulture, "{{\"joints\": {0}, \"worst\": {1}}}", joints,
            double.IsInfinity(worst) ? "1e9" : worst.ToString("R", CultureInfo.InvariantCulture)));
        return 0;
    }
}
