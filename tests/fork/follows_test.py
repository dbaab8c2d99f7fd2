#!/usr/bin/env python3
"""The tables that ode/compare reads, compared with the pinned release and this repository: whatever they name is there.

    follows_test.py REPOSITORY UPSTREAM

UPSTREAM: the unpacked sources of the pinned release.
"""
import pathlib
import re
import subprocess
import sys
import unittest

UPSTREAM = pathlib.Path(sys.argv.pop(2)).resolve()
REPOSITORY = pathlib.Path(sys.argv.pop(1)).resolve()
sys.dont_write_bytecode = True
sys.path.insert(0, str(REPOSITORY / "ode"))

from comparison.ours import Ours
from comparison.releases import version_of
from comparison.symbols import Tree
from comparison.tables import followed_keys, places_of, read_follows, read_seams


class Follows(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.tree = Tree(UPSTREAM)
        cls.follows = read_follows(REPOSITORY)
        cls.seams = read_seams(REPOSITORY, version_of(UPSTREAM)[0])

    def entries(self):
        for entry in self.follows:
            for path, names in entry.upstream.items():
                for name in names:
                    yield entry, path, name

    def test_upstream_has_what_the_table_names(self):
        missing = [f"{path}: {name} ({entry.what})" for entry, path, name in self.entries()
                   if not followed_keys([name], self.tree.symbols.get(path, {}))]
        self.assertEqual(missing, [])

    def test_we_have_what_the_table_names(self):
        missing = [path for entry in self.follows for path in entry.ours + entry.tests if not places_of(REPOSITORY, path)]
        self.assertEqual(missing, [])
        self.assertEqual([entry.what for entry in self.follows if not entry.ours or not entry.tests], [])

    def test_nothing_is_named_twice_in_one_entry(self):
        named = [(entry.what, path, name) for entry, path, name in self.entries()]
        self.assertEqual(len(named), len(set(named)))

    def test_seams_name_what_upstream_has(self):
        self.assertTrue(self.seams.renamed and self.seams.replaced and self.seams.compiled_after)
        for path, function in self.seams.renamed:
            self.assertIsNotNone(self.tree.symbol(path, ("function", function)), f"{function} in {path}")
        for (function, replacement), paths in self.seams.replaced.items():
            self.assertTrue(self.tree.by_key.get(("function", function)) or self.tree.by_key.get(("variable", function)), function)
            self.assertTrue(re.search(r"\bdx\w+", replacement), replacement)
            self.assertEqual([path for path in paths if path not in self.seams.compiled], [])
        for path, header in self.seams.compiled_after:
            self.assertIn(path, self.seams.compiled)
            self.assertTrue((REPOSITORY / header).is_file(), header)
        self.assertEqual([path for path in self.seams.compiled if path not in self.tree.files], [])

    def test_seams_are_all_read(self):
        text = re.sub(r"#[^\n]*", "", (REPOSITORY / "ode" / "seams.cmake").read_text())
        renamed = {function for _, function in self.seams.renamed}
        for arguments in re.findall(r"\bode_mt_rename\(\s*([\w/]+\.cpp[^)]*)\)", text):
            self.assertLessEqual(set(arguments.split()[1:]), renamed)
        for function in re.findall(r'\bode_mt_call_instead\("[^"]*" (\w+) ', text):
            self.assertIn(function, {replaced for replaced, _ in self.seams.replaced})

    def test_what_ours_replaces_is_followed(self):
        """A renamed function that ours never calls, a function that is called by another name, and a file that is left out."""
        followed = {(path, key) for entry in self.follows for path, names in entry.upstream.items()
                    for key in followed_keys(names, self.tree.symbols.get(path, {}))}
        ours = Ours(REPOSITORY, self.tree)
        for path, function in self.seams.renamed:
            if not ours.users([re.sub("^d", "dxUpstream", function)]):
                self.assertIn((path, ("function", function)), followed)
        for function, _ in self.seams.replaced:
            paths = self.tree.by_key.get(("function", function), [])
            self.assertTrue(not paths or any((path, ("function", function)) in followed for path in paths), function)
        left_out = re.findall(r"\b(\w+\.cpp) is left out", (REPOSITORY / "ode" / "seams.cmake").read_text())
        self.assertTrue(left_out)
        for name in left_out:
            self.assertNotIn(f"ode/src/{name}", self.seams.compiled)
            self.assertIn((f"ode/src/{name}", ("rest", "(rest of the file)")), followed)

    def test_a_release_differs_from_itself_in_nothing(self):
        run = subprocess.run([REPOSITORY / "ode" / "compare", UPSTREAM, UPSTREAM], capture_output=True, text=True, check=False)
        self.assertEqual((run.returncode, run.stdout.splitlines()[-1:], run.stderr), (0, ["Nothing needs work."], ""))

    def test_the_releases_of_debian_12_and_13(self):
        """Names that were compared by hand with a diff of the two; skipped where one of them is not unpacked and not in the cache."""
        run = subprocess.run([REPOSITORY / "ode" / "compare", "0.16.2", "0.16.6"], capture_output=True, text=True, check=False)
        if run.returncode == 2 and "is not here" in run.stderr:
            self.skipTest(run.stderr.strip())
        self.assertEqual((run.returncode, run.stderr), (1, ""))
        changed = {re.sub(r"^(macro|type|declaration of) ", "", line.strip()[2:].split(": ", 1)[1]).split()[0]
                   for line in run.stdout.splitlines() if line.strip().startswith("! ode/src/quickstep.cpp: dx")}
        self.assertEqual(changed, {
            "dxQuickStepIsland", "dxEstimateQuickStepMaxCallCount",
            *(f"dxQuickStepIsland_Stage{stage}" for stage in (
                "0_Bodies", "1", "2a", "2b", "3", "4a", "4b", "6a", "6b", "4LCP_AdComputation", "4LCP_MTfcComputation_cold",
                "4LCP_iMJSync_Callback", "4LCP_fcStart_Callback", "4LCP_IterationStart_Callback", "4LCP_IterationSync_Callback"))})
        for line in ("dCollideConvexTrimeshTrianglesCCD changed +1 -1", "dLCP::dLCP changed", "dxProcessIslands changed",
                     "calculateIslandProcessingMaxThreadCount gone, perhaps now dxWorld::calculateIslandIterationMaxThreadCount",
                     "dJointAddPUTorques new", "libode.so.8.0.2 is libode.so.8.2.0"):
            self.assertIn(line, run.stdout)
        for line in ("dxSolveLCP", "BuildIslandsAndEstimateStepperMemoryRequirements", "dxStepBody", "dBoxBox", "dxHashSpace"):
            self.assertNotIn(f"{line} changed", run.stdout)


if __name__ == "__main__":
    unittest.main()
