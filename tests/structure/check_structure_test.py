# tests/structure/check_structure_test.py: each rule of check_structure.py finds what breaks it, and only that.
import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
import check_structure  # noqa: E402


class Structure(unittest.TestCase):
    def problems(self, pages=True, **tree):
        """`tree`: path with "/" as "__" and "." as "_DOT_" -> text. pages: each room has its README.md."""
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in {"tests__CMakeLists_DOT_txt": "foreach(room geometry)", **tree}.items():
                path = root / name.replace("__", "/").replace("_DOT_", ".")
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text)
            for room in [*root.glob("core/*"), *root.glob("app/*")] if pages else []:
                if room.is_dir() and room.name != "include":
                    rows = "".join("| %s | x |\n" % row for row in ("comes in", "goes out", "may include", "tests"))
                    (room / "README.md").write_text("# %s\n\n%s" % (room.relative_to(root).as_posix(), rows))
            return list(check_structure.problems(root))

    def header(self, path, body=""):
        return "#pragma once  // %s: x\n%s" % (path, body)

    def one(self, words, **tree):
        found = self.problems(**tree)
        self.assertEqual(len(found), 1, found)
        self.assertIn(words, found[0])

    def test_valid_tree_has_no_problem(self):
        self.assertEqual([], self.problems(
            core__geometry__weld_DOT_h=self.header("core/geometry/weld.h", '#include <array>\n#include "sinew/geometry/result.h"\n'),
            core__files__gltf_DOT_cpp="// core/files/gltf.cpp: x\n#include <tiny_gltf.h>\n#include <nlohmann/json.hpp>\n",
            app__main_DOT_cpp='// app/main.cpp: x\n#include "app/command/verbs.h"\n#include "core/files/gltf.h"\n',
            tests__geometry__weld_test_DOT_cpp="// tests/geometry/weld_test.cpp: x\n#include <tiny_gltf.h>\n",
            run_DOT_sh="#!/bin/sh\n# run.sh: x\n", shaders__a_DOT_frag="#version 450 core\n// shaders/a.frag: x\n"))

    def test_core_including_app(self):
        body = '#include "app/document/document.h"\n'
        self.one("core never includes app", core__rig__a_DOT_h=self.header("core/rig/a.h", body))

    def test_the_python_module_including_more_than_core(self):
        for header in ('"app/document/document.h"', "<tiny_gltf.h>", "<GLFW/glfw3.h>"):
            body = "// python/module/a.cpp: x\n#include %s\n" % header
            self.one("the Python module includes core alone", python__module__a_DOT_cpp=body)
        body = '// python/module/a.cpp: x\n#include "core/rig/rig_edit.h"\n#include <pybind11/pybind11.h>\n'
        self.assertEqual([], self.problems(python__module__a_DOT_cpp=body))

    def test_a_test_of_core_including_app(self):
        for here in ("geometry", "support/rigs"):
            path = "tests/%s/a.h" % here
            for header in ("app/command/measuring.h", "tests/viewport/tools/limb_scene.h", "tests/support/editor/drawn_text.h"):
                body = self.header(path, '#include "%s"\n' % header)
                tree = {"tests__CMakeLists_DOT_txt": "geometry support", path.replace("/", "__").replace(".", "_DOT_"): body}
                self.one("tests of core include nothing of app", **tree)
        body = self.header("tests/support/editor/a.h", '#include "app/command/measuring.h"\n')
        self.assertEqual([], self.problems(tests__CMakeLists_DOT_txt="support", tests__support__editor__a_DOT_h=body))

    def test_core_including_templates_that_programs_have_too(self):
        for header in ("<Eigen/Core>", "<tbb/parallel_for.h>", "<oneapi/tbb.h>"):
            self.one("knows it", core__rig__a_DOT_cpp="// core/rig/a.cpp: x\n#include %s\n" % header)
        self.assertEqual([], self.problems(core__geometry__own_tasks_DOT_cpp="// core/geometry/own_tasks.cpp: x\n#include <tbb/tbb.h>\n"))

    def test_a_public_header_that_asks_for_no_library(self):
        for body in ("", "#include <array>\n", '#include "sinew/geometry/version.h"\n'):
            self.one("include sinew/geometry/same_version.h",
                     core__include__sinew__rig__a_DOT_h=self.header("core/include/sinew/rig/a.h", body))
        for body in ('#include "sinew/geometry/same_version.h"\n', '#include "sinew/geometry/result.h"\n'):
            self.assertEqual([], self.problems(
                core__include__sinew__rig__a_DOT_h=self.header("core/include/sinew/rig/a.h", body)))

    def test_core_including_a_window(self):
        for header in ("epoxy/gl.h", "GLFW/glfw3.h", "imgui.h"):
            self.one("core knows no window", core__files__a_DOT_h=self.header("core/files/a.h", "#include <%s>\n" % header))

    def test_file_libraries_outside_files(self):
        for header in ("tiny_gltf.h", "nlohmann/json.hpp"):
            self.one("only core/files", core__rig__a_DOT_h=self.header("core/rig/a.h", "#include <%s>\n" % header))
            self.one("only core/files", app__command__a_DOT_h=self.header("app/command/a.h", "#include <%s>\n" % header))

    def test_a_room_above_and_one_beside(self):
        self.one("not surface", core__geometry__a_DOT_h=self.header("core/geometry/a.h", '#include "sinew/surface/surface.h"\n'))
        self.one("not character", core__geometry__a_DOT_h=self.header("core/geometry/a.h", '#include "sinew/character/pose.h"\n'))
        self.one("not viewport/tools", app__viewport__render__a_DOT_h=self.header("app/viewport/render/a.h", '#include "app/viewport/tools/gizmo.h"\n'))

    def test_the_runtime_including_what_a_game_does_not_link(self):
        body = '#include "core/files/disk/a.h"\n'
        self.one("runtime may include only", core__runtime__a_DOT_h=self.header("core/runtime/a.h", body))
        self.assertEqual([], self.problems(core__files__export__a_DOT_h=self.header("core/files/export/a.h", body)))

    def test_an_unknown_directory(self):
        self.one("has no layer", core__attic__a_DOT_h=self.header("core/attic/a.h", '#include "sinew/geometry/result.h"\n'))

    def test_a_first_line_that_names_another_file(self):
        self.one("does not name the file", core__rig__a_DOT_h=self.header("core/rig/b.h"))

    def test_a_long_line(self):
        self.one("more than 120", core__rig__a_DOT_h=self.header("core/rig/a.h", "// " + "x" * 118 + "\n"))
        self.assertEqual([], self.problems(core__rig__a_DOT_h=self.header("core/rig/a.h", "// " + "x" * 117 + "\n")))

    def test_a_constant_that_hides_a_headers(self):
        def tree(place, name):
            return {"core__geometry__a_DOT_h": self.header("core/geometry/a.h", "inline constexpr float kLeast = 0.2f;\n"),
                    place: "// %s: x\nconstexpr float %s = 0.5f;\n" % (place.replace("__", "/").replace("_DOT_", "."), name)}

        self.one("kLeast would hide that of core/geometry/a.h", **tree("core__rig__b_DOT_cpp", "kLeast"))
        self.assertEqual([], self.problems(**tree("core__rig__b_DOT_cpp", "kLeastOfRig")))
        self.assertEqual([], self.problems(**tree("app__ui__b_DOT_cpp", "kLeast")))

    def test_a_test_no_one_runs(self):
        self.one("names 'attic'", tests__attic__a_test_DOT_cpp="// tests/attic/a_test.cpp: x\n")
        self.one("names 'a_test.py'", tests__geometry__a_test_DOT_py="# tests/geometry/a_test.py: x\n")

    def test_a_page_that_names_what_is_not_there(self):
        here = {"core__geometry__weld_DOT_h": self.header("core/geometry/weld.h")}
        for page in ("README_DOT_md", "CONTRIBUTING_DOT_md", "docs__design_DOT_md"):
            self.one(":2: `core/geometry/old.h` does not exist", **here, **{page: "# Head\nSee `core/geometry/old.h`.\n"})
        self.one("`core/geometry/weld.cpp`", README_DOT_md="`core/geometry/weld.{h,cpp}`\n", **here)
        self.one("`tests/geometry`", README_DOT_md="`ctest tests/geometry`\n", **here)
        self.assertEqual([], self.problems(README_DOT_md="`core/geometry/weld.h` `core/geometry/` `core/geometry/*.h` "
                                           "`app/command/NAME.cpp` `Sinew::core` core/geometry/old.h\n", **here))

    def test_a_room_without_a_page(self):
        self.one("core/rig/README.md: expected", pages=False, core__rig__a_DOT_h=self.header("core/rig/a.h"))
        page = "# core/rig\n\n| comes in | x |\n| goes out | x | | may include | x |\n| tests | x |\n"
        self.one("core/rig/README.md: expected", pages=False, core__rig__a_DOT_h=self.header("core/rig/a.h"), core__rig__README_DOT_md=page)

    def test_a_sample_that_nobody_compiles(self):
        page = "```cpp\n  int x = 1;\n```\n"
        self.one("'int x = 1;' is not in", README_DOT_md=page)
        sample = "// tests/install/consumer/main.cpp: x\nint x = 1;\n"
        tree = {"tests__install__consumer__main_DOT_cpp": sample,
                "tests__CMakeLists_DOT_txt": "foreach(room geometry install)"}
        self.assertEqual([], self.problems(README_DOT_md=page, **tree))


if __name__ == "__main__":
    unittest.main()
