#!/usr/bin/env python3
"""ode/compare on two small source trees and a small fork of them, all written here: what it names, what it does not, how it ends.

    compare_test.py REPOSITORY
"""
import os
import pathlib
import re
import subprocess
import sys
import tarfile
import tempfile
import textwrap
import unittest

REPOSITORY = pathlib.Path(sys.argv.pop(1)).resolve()

OLD = {
    "configure.ac": """
        AC_INIT([ODE],[1.0.0],[nobody])
        CURRENT=8
        REVISION=2
        AGE=0
        """,
    "include/ode/things.h": """
        #define dKept 1
        ODE_API void dThingMove (dThingID, dReal by);
        ODE_API void dThingStop (dThingID);
        ODE_API int dThingCount (void);
        """,
    "ode/src/things.h": """
        #define STEP 4
        struct dxThing { double place; int count; };
        struct dxOther { int unused; };
        void stepThings (dxThing *things, int count);
        """,
    "ode/src/things.cpp": """
        #include "things.h"
        static double half (double a) { return a / 2; }
        // A comment.
        void stepThings (dxThing *things, int count)
        {
            for (int i = 0; i < count; i += STEP) things[i].place += half (1);
        }
        template <class T>
        T
        sumThings (const T *values) { T sum = 0; for (int i = 0; i < 3; ++i) sum += values[i]; return sum; }
        void dThingMove (dThingID thing, dReal by) { thing->place += by; }
        void dThingStop (dThingID thing) { thing->place = 0; }
        int dThingCount (void) { return 1; }
        void walkThings (dxThing *things) { stepThings (things, 2); }
        """,
    "ode/src/other.cpp": """
        int asItIs () { return 1; }
        """,
}
FORK = {
    "ode/sources.cmake": """
        set(ODE_MT_UPSTREAM_SOURCES "${ODE_MT_UPSTREAM_DIR}/ode/src/things.cpp" "${ODE_MT_UPSTREAM_DIR}/ode/src/other.cpp")
        """,
    "ode/seams.cmake": """
        file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/seams/dThingMove.h" CONTENT "")
        set_property(SOURCE "${ODE_MT_UPSTREAM_DIR}/ode/src/things.cpp" APPEND PROPERTY
            COMPILE_OPTIONS -include "${CMAKE_CURRENT_BINARY_DIR}/seams/dThingMove.h")
        set_property(SOURCE "${ODE_MT_UPSTREAM_DIR}/ode/src/things.cpp" APPEND PROPERTY COMPILE_DEFINITIONS walkThings=dxWalkThings)
        """,
    "ode/follows.toml": """
        [[follows]]
        what = "steps"
        ours = ["ode_mt/dxSteps"]
        tests = ["tests/steps_test.cpp"]
        upstream."ode/src/things.cpp" = ["stepThings", "sum*"]
        """,
    "ode_mt/dxSteps.cpp": """
        #include "things.h"
        void dThingMove(dThingID thing, dReal by) { dxUpstreamThingMove(thing, by); }
        double placeOf(const dxThing &thing) { return thing.place; }
        """,
    "tests/steps_test.cpp": "",
}


class Compare(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.write("fork", FORK)
        self.write("old", OLD)

    def write(self, tree, files):
        for path, text in files.items():
            place = self.folder / tree / path
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_text(textwrap.dedent(text).lstrip())

    def edited(self, path, *edits):
        """OLD with edits of one file."""
        text = textwrap.dedent(OLD[path])
        for before, after in edits:
            self.assertIn(before, text)
            text = text.replace(before, after)
        return {**OLD, path: text}

    def run_tool(self, *arguments, **environment):
        return subprocess.run([sys.executable, REPOSITORY / "ode" / "compare", "--repository", self.folder / "fork", *arguments],
                              capture_output=True, text=True, check=False, env={**os.environ, **environment})

    def compare(self, files, *options):
        """The exit status, and the lines of each group."""
        self.write("new", files)
        run = self.run_tool(self.folder / "old", self.folder / "new", *options)
        self.assertEqual(run.stderr, "")
        groups, group = {}, None
        for line in run.stdout.splitlines():
            if heading := re.match(r"(\S.*): \d+$", line):
                group = groups.setdefault(heading[1], [])
            elif group is not None and line.startswith(" "):
                group.append(line.strip())
        return run.returncode, groups

    def assert_one(self, groups, group, pattern):
        found = [line for line in groups.get(group, []) if line.startswith(("! ", "- "))]
        self.assertEqual(len(found), 1, groups)
        self.assertRegex(found[0], pattern)

    def test_equal_trees_need_no_work(self):
        self.assertEqual(self.compare(OLD), (0, {}))

    def test_comments_and_white_space_are_ignored(self):
        status, groups = self.compare(self.edited(
            "ode/src/things.cpp", ("// A comment.", "/* Another\n one. */"), ("(int i = 0; i < count;", "( int i=0 ;\n\t i<count ; // each\n"),
            ("template <class T>\nT\n", "template<class T> T ")))
        self.assertEqual((status, groups), (0, {}))

    def test_names_exactly_the_changed_function(self):
        status, groups = self.compare(self.edited("ode/src/things.cpp", ("half (1)", "half (2)")))
        self.assertEqual(status, 1)
        self.assertEqual(list(groups), ["Changed, and ours follows it"])
        self.assert_one(groups, "Changed, and ours follows it", r"^! ode/src/things\.cpp: stepThings changed \+1 -1$")
        self.assertIn("ours: ode_mt/dxSteps", groups["Changed, and ours follows it"])
        self.assertIn("tests: tests/steps_test.cpp", groups["Changed, and ours follows it"])

    def test_text_above_the_name_belongs_to_the_function(self):
        _, groups = self.compare(self.edited("ode/src/things.cpp", ("template <class T>", "template <class T> inline")))
        self.assert_one(groups, "Changed, and ours follows it", "sumThings changed")

    def test_text_in_quotes_counts(self):
        tree = self.edited("ode/src/other.cpp", ("return 1", 'return sizeof "/* a */ // b"'))
        self.write("old", tree)
        _, groups = self.compare({**tree, "ode/src/other.cpp": tree["ode/src/other.cpp"].replace("/* a */", "/* c */")})
        self.assert_one(groups, "Changed, compiled as it is: nothing to do but the tests", "asItIs changed")

    def test_what_a_followed_function_uses(self):
        status, groups = self.compare(self.edited("ode/src/things.cpp", ("a / 2", "a / 3")))
        self.assertEqual(status, 1)
        self.assert_one(groups, "Changed, and ours follows it", "^! .*half changed.*used by stepThings")
        status, groups = self.compare(self.edited("ode/src/things.h", ("STEP 4", "STEP 8")))
        self.assertEqual(status, 1)
        self.assert_one(groups, "Changed, and ours follows it", "^! .*macro STEP changed.*used by stepThings")

    def test_names_that_changed_alone_are_said(self):
        _, groups = self.compare(self.edited("ode/src/things.cpp", ("int i = 0; i < count; i += STEP) things[i]",
                                                                    "int k = 0; k < count; k += STEP) things[k]")))
        self.assert_one(groups, "Changed, and ours follows it", r"\(only names: i is k\)")

    def test_moved_functions(self):
        tree = self.edited("ode/src/things.cpp", ("static double half (double a) { return a / 2; }\n", ""))
        self.assertEqual(self.compare({**tree, "ode/src/things.cpp": tree["ode/src/things.cpp"] + "static double half (double a) { return a / 2; }\n"}),
                         (0, {}))
        step = re.search(r"void stepThings.*?\n}\n", textwrap.dedent(OLD["ode/src/things.cpp"]), re.DOTALL)[0]
        tree = self.edited("ode/src/things.cpp", (step, ""))
        status, groups = self.compare({**tree, "ode/src/other.cpp": textwrap.dedent(OLD["ode/src/other.cpp"]) + step})
        self.assertEqual(status, 0)
        self.assert_one(groups, "Changed, and ours follows it", r"^- .*stepThings moved \(to ode/src/other\.cpp\)")
        status, groups = self.compare({**tree, "ode/src/other.cpp": textwrap.dedent(OLD["ode/src/other.cpp"]) + step.replace("(1)", "(3)")})
        self.assertEqual(status, 1)
        self.assert_one(groups, "Changed, and ours follows it", r"stepThings moved and changed \(to ode/src/other\.cpp\)")

    def test_gone_functions_and_what_they_may_be_now(self):
        status, groups = self.compare(self.edited("ode/src/things.cpp", ("void stepThings (", "void stepAllThings (")))
        self.assertEqual(status, 1)
        self.assertRegex("\n".join(groups["Changed, and ours follows it"]), "stepThings gone, perhaps now stepAllThings")

    def test_exports(self):
        status, groups = self.compare(self.edited("include/ode/things.h", ("ODE_API int dThingCount (void);", "ODE_API int dThingNumber (void);")))
        self.assertEqual(status, 1)
        exports = "\n".join(groups["Exports: new, gone, declared otherwise"])
        self.assertRegex(exports, "dThingNumber new, declared and never defined")
        self.assertRegex(exports, "dThingCount gone, perhaps now dThingNumber")
        self.assertNotIn("dThingMove", exports)

    def test_public_macros_and_types(self):
        status, groups = self.compare(self.edited("include/ode/things.h", ("#define dKept 1", "#define dKept 2")))
        self.assertEqual(status, 1)
        self.assert_one(groups, "Changed in the public headers", "macro dKept changed")

    def test_renamed_functions(self):
        status, groups = self.compare(self.edited("ode/src/things.cpp", ("place += by;", "place -= by;")))
        self.assertEqual(status, 0)
        self.assert_one(groups, "Changed, and renamed only (signature compared)", "^- .*dThingMove changed.*signature unchanged.*ode_mt/dxSteps.cpp")
        both = self.edited("ode/src/things.cpp", ("(dThingID thing, dReal by)", "(dThingID thing, double by)"))
        both["include/ode/things.h"] = OLD["include/ode/things.h"].replace("dThingID, dReal by", "dThingID, double by")
        status, groups = self.compare(both)
        self.assertEqual(status, 1)
        self.assert_one(groups, "Changed, and renamed only (signature compared)", "^! .*SIGNATURE CHANGED")
        status, groups = self.compare(self.edited("ode/src/things.cpp", ("void dThingMove", "void dThingShift")))
        self.assertEqual(status, 1)
        self.assert_one(groups, "The tables do not fit", "renames dThingMove in ode/src/things.cpp; it is gone")

    def test_functions_that_are_called_by_another_name(self):
        status, groups = self.compare(self.edited("ode/src/things.cpp", ("stepThings (things, 2)", "stepThings (things, 3)")))
        self.assertEqual(status, 1)
        self.assertIn("ours: dxWalkThings (ode/seams.cmake)", groups["Changed, and ours follows it"])
        _, groups = self.compare(self.edited("ode/src/other.cpp", ("return 1;", "walkThings (0); return 1;")))
        self.assert_one(groups, "The tables do not fit", "ode/src/other.cpp uses walkThings as well")

    def test_internal_headers(self):
        status, groups = self.compare(self.edited("ode/src/things.h", ("double place; int count;", "double place; long count;")))
        self.assertEqual(status, 1)
        self.assert_one(groups, "Changed in internal headers that ours includes", "^! .*type dxThing changed.*used in ode_mt/dxSteps.cpp")
        status, groups = self.compare(self.edited("ode/src/things.h", ("int unused", "long unused")))
        self.assertEqual(status, 0)
        self.assert_one(groups, "Changed in internal headers that ours includes", "^- .*type dxOther changed")

    def test_files(self):
        status, groups = self.compare({**OLD, "ode/src/added.cpp": "int added () { return 1; }\n"})
        self.assertEqual(status, 1)
        self.assert_one(groups, "Source files: new, gone", "ode/src/added.cpp new: compile it")
        self.folder.joinpath("new/ode/src/added.cpp").unlink()
        self.folder.joinpath("new/ode/src/other.cpp").unlink()
        _, groups = self.compare({path: text for path, text in OLD.items() if path != "ode/src/other.cpp"})
        self.assert_one(groups, "Source files: new, gone", "ode/src/other.cpp gone: ode/sources.cmake compiles it")

    def test_build_configuration(self):
        self.assertEqual(self.compare(self.edited("configure.ac", ("1.0.0", "1.0.1")))[0], 0)
        status, groups = self.compare(self.edited("configure.ac", ("CURRENT=8", "CURRENT=10"), ("AGE=0", "AGE=2\nAC_ARG_ENABLE(speed, yes)")))
        self.assertEqual(status, 1)
        build = "\n".join(groups["Build configuration"])
        self.assertIn("libode.so.8.0.2 is libode.so.8.2.2", build)
        self.assertIn("configure.ac changed; options new: speed", build)

    def test_differences_are_shown_on_request(self):
        _, groups = self.compare(self.edited("ode/src/things.cpp", ("half (1)", "half (2)"), ("place = 0", "place = 1")),
                                 "--diff", "--only", "stepThings")
        text = "\n".join(line for lines in groups.values() for line in lines)
        self.assertIn("+for(int i = 0; i < count; i += STEP) things[i].place += half(2);", text)
        self.assertNotIn("dThingStop", text)

    def test_archives_and_release_numbers(self):
        cache = self.folder / "cache" / "ode_mt"
        cache.mkdir(parents=True)
        with tarfile.open(cache / "ode_1.0.0.orig.tar.gz", "w:gz") as archive:
            archive.add(self.folder / "old", "ode-1.0.0")
        self.write("fork/ode/upstream/ode-1.1", OLD)
        for name in ("1.0.0", "1.1", cache / "ode_1.0.0.orig.tar.gz", self.folder / "old"):
            run = self.run_tool(self.folder / "old", name, XDG_CACHE_HOME=str(cache.parent))
            self.assertEqual((run.returncode, run.stderr), (0, ""), name)

    def test_bad_arguments(self):
        (self.folder / "text").write_text("no archive")
        for arguments, message in ((("9.9.9", self.folder / "old"), "release 9.9.9 is not here"),
                                   ((self.folder / "old", self.folder / "nowhere"), "no release number, no folder, no archive"),
                                   ((self.folder / "old", self.folder / "text"), "cannot be unpacked"),
                                   ((self.folder / "old", self.folder / "fork"), "holds no sources of ODE"), ((), "required")):
            run = self.run_tool(*arguments, XDG_CACHE_HOME=str(self.folder))
            self.assertEqual((run.returncode, run.stdout), (2, ""), arguments)
            self.assertIn(message, run.stderr)
        (self.folder / "fork/ode/follows.toml").write_text("[[follows")
        run = self.run_tool(self.folder / "old", self.folder / "old")
        self.assertEqual(run.returncode, 2)
        self.assertIn("follows.toml cannot be read", run.stderr)


if __name__ == "__main__":
    unittest.main()
