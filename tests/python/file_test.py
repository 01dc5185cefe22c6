# tests/python/file_test.py: numbers of nodes and vertex colors, against a reader that shares no code.
import shutil

from tools import ASSETS, Case, main, numpy, sinew
from colored_glb import write_colored  # noqa: E402: tools says where it is
from glb_reader import Glb  # noqa: E402


class Files(Case):
    def test_bones_match_the_files_nodes(self):
        for name in ("humanoid", "horse", "demo", "tangle", "wrapped"):
            character = sinew.load(ASSETS / (name + ".glb"))
            root = Glb(ASSETS / (name + ".glb")).json
            nodes = character.nodes()
            names = [bone.path.split("/")[-1] for bone in character.bones]
            self.assertEqual([root["nodes"][node]["name"] for node in nodes], names)
            self.assertEqual(set(nodes), {joint for skin in root["skins"] for joint in skin["joints"]})
            parents = {child: number for number, node in enumerate(root["nodes"]) for child in node.get("children", ())}
            for bone, node in zip(character.bones, nodes):
                above = parents.get(node)
                self.assertEqual(nodes[bone.parent] if bone.parent >= 0 else None, above if above in nodes else None)

    def test_changed_file_is_refused(self):
        path = self.folder / "changed.glb"
        shutil.copy(ASSETS / "demo.glb", path)
        character = sinew.load(path)
        shutil.copy(ASSETS / "horse.glb", path)
        self.assertIn("has changed", str(self.refusal(character.nodes)))
        path.unlink()
        self.refusal(character.nodes)

    def test_colors_match_the_file(self):
        self.assertEqual(self.smoother().colors.shape, (0, 4))
        character = sinew.load(write_colored(ASSETS / "humanoid.glb", self.folder / "colored.glb"))
        rig = sinew.Rig(character)
        rig.detail, rig.depth = "uniform", 3
        surface = sinew.Smoother(character, rig)()
        self.assertEqual(surface.colors.shape, (len(surface.uv), 4))
        self.assertEqual(surface.colors.dtype, numpy.float32)
        numpy.testing.assert_allclose(surface.colors[:, :2], surface.uv, atol=1e-6)
        numpy.testing.assert_allclose(surface.colors[:, 2:], [[0.25, 1.0]] * len(surface.uv), atol=1e-6)
        self.assertFalse(surface.colors.flags.writeable)


if __name__ == "__main__":
    main()
