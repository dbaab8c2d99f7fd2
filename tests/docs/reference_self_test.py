#!/usr/bin/env python3
"""The reference finds functions of headers, sees which are in no group or in several, and links documents: reference_self_test.py REPOSITORY"""
import pathlib
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(sys.argv[1]) / "docs" / "reference"))
from build import linked  # noqa: E402
from upstream_functions import complaints, declarations_in  # noqa: E402

HEADER = """
/* ODE_API void dInComment(int); */
#define ODE_API \\
    void dInMacro(int)
ODE_API int dPlain (dWorldID world, dReal /*unused*/);
ODE_API_DEPRECATED ODE_API void dOld(void);
ODE_API const dReal *dSplit(dBodyID,
                            int (*callback)(int, int));   // ODE_API void dAfterwards(void);
ODE_PURE_INLINE void dInline(dReal *result) { result[0] = 0; }
typedef void dCallback(void);
"""
FOUND = dict(declarations_in(HEADER))
assert FOUND == {
    "dPlain": "int dPlain(dWorldID world, dReal);",
    "dOld": "void dOld(void);",
    "dSplit": "const dReal * dSplit(dBodyID, int (*callback)(int, int));",
    "dInline": "void dInline(dReal *result);",
}, FOUND

assert not list(complaints({"dOne", "dTwo"}, {"a": ["dOne"], "b": ["dTwo"]}))
assert list(complaints({"dOne", "dTwo"}, {"a": ["dOne"]})) == ["dTwo is in no group"]
assert len(list(complaints({"dOne", "dTwo"}, {"a": ["dOne", "dTwo"], "b": ["dTwo"]}))) == 1
assert len(list(complaints({"dOne"}, {"a": ["dOne", "dThree"]}))) == 1
assert not list(complaints({"dOne"}, {"a": ["dOne", "dThree"]}, {"dThree"}))

assert linked("/** docs/step.md, dOne */ docs/step.md", {"dOne"}) == "/** [docs/step.md](../docs/step.html), #dOne */ docs/step.md"
assert linked("/** (docs/step.md#the-end). */", set()) == "/** ([docs/step.md](../docs/step.html#the-end)). */"
