"""The suites that mutants have to pass, by the folder that a mutant is in.

Programs that run on the shared library are those of a finished build; they find the mutant's library by a variable or an
option. Unit tests are compiled with the mutants, since they have inline functions of the library's in them.
"""
import dataclasses
import pathlib
import re

# By the start of the file's path: programs that are linked with the library's inside.
_UNITS = {
    "ode_mt/collision/": ["collision/search_parts_tests"],
    "ode_mt/clusters/heuristics/": ["heuristics/heuristics_tests"],
    "ode_mt/clusters/": ["clustering/clustering_tests"],
    "ode_mt/dynamics/world_step/fast/": ["dynamics/fast_world_step_tests"],
    "ode_mt/dynamics/quick_step/fast/": ["dynamics/pgs_tests"],
    "ode_mt/dynamics/": ["dynamics/lcp_tests", "dynamics/stepper_tests", "dynamics/dynamics_tests", "dynamics/pgs_tests"],
    "ode_mt/remote/": ["remote/remote_tests"],
    "ode_mt/threading/timeline/": ["threading/threading_tests", "frame/timeline_test"],
    "ode_mt/core/": ["dynamics/lcp_tests", "dynamics/dynamics_tests", "collision/search_parts_tests", "clustering/clustering_tests",
                     "threading/threading_tests"],
    "ode_mt/threading/": ["threading/threading_tests"],
    "ode_mt/": ["frame/frame_tests"],  # and for all others, last of all suites
}

# Themes of the exactness suite that play most of a folder's code, and in which settings.
_THEMES = {
    "ode_mt/collision/": ["space_churn", "hash_levels", "sleeping_crowds", "arrays_in_callbacks"],
    "ode_mt/clusters/": ["space_churn", "stray_geoms"],
    "ode_mt/dynamics/": ["powered_stops", "many_rows", "large_exact_islands", "singular_islands"],
    "ode_mt/api/": ["creation", "geom_ownership", "messages", "random_stream"],
    "ode_mt/": ["moved_callbacks", "several_worlds", "callback_liberties", "user_threading"],
}
_SETTINGS = ["pthread_3", "lcp_3*", "decluster_3*"]

# And those for what has survived all of that.
_JOINTS = ["*_joints", "joint_feedback", "powered_stops", "sensors"]
_MORE_THEMES = {
    "ode_mt/collision/": ["box_functions", "callback_liberties", "collide_flags", "collision_spaces", "convex_crowds", "crowd_extremes",
                          "first_meetings", "geom_*", "leaving_heights", "locked_spaces", "mesh_callbacks", "moving_meshes",
                          "shared_scenes", "space_kinds", "stray_geoms", "sweep_spaces", "terrain*", "user_colliders"],
    "ode_mt/clusters/": ["collision_spaces", "crowd_extremes", "first_meetings", "shared_scenes", "space_kinds", "terrain_crowds"],
    "ode_mt/dynamics/": ["friction", "large_islands", "random_stream", "wandering_rows", "wide_*", "world_parameters"],
    "ode_mt/api/": [*_JOINTS, "auto_disable", "body_motion", "collide_flags", "faults", "kinematic_bodies", "world_parameters"],
    "ode_mt/": [],
}
_MORE_FRAME_THEMES = ["faults", "float_environment", "large_islands", "messages", "random_stream"]
_MORE_UNITS = ["frame/steady_state_test", "frame/churn_memory_test"]
_MORE_SETTINGS = ["pthread_2", "lcp_2_concurrent", "lcp_3_independent"]  # the first has a disturbed schedule and asks who took part


# Long ones of the frame's: what they show, the others show, too.
_FRAME_FILTER = "--gtest_filter=-*Progress*:*ManyWorlds*:*Exits*:*End*:*Restep*"


@dataclasses.dataclass(frozen=True)
class Suite:
    name: str
    command: tuple
    environment: tuple = ()  # pairs


def _first(table, file):
    return next(value for start, value in table.items() if file.startswith(start))


def _programs(file):
    return list(dict.fromkeys(_first(_UNITS, file) + _UNITS["ode_mt/"]))


def _concept_filter(repository, program, file):
    """A filter for the tests of the mutant's concept (dxSapSort: sap_sort_test.cpp), or None."""
    concept = re.sub(r"(?<!^)(?=[A-Z])", "_", pathlib.Path(file).stem.removeprefix("dx")).lower()
    path = repository / "tests" / pathlib.Path(program).parent / f"{concept}_test.cpp"
    if not path.exists():
        return None
    suites = set(re.findall(r"^(?:TYPED_)?TEST(?:_[FP])?\((\w+),", path.read_text(), flags=re.M))
    return ":".join(f"*{suite}*" for suite in sorted(suites)) or None


def targets_for(file):
    """The programs that the units of a file are tested by, as CMake names them."""
    return [pathlib.Path(program).name for program in _programs(file) + _MORE_UNITS]


def suites_for(file, repository, built, objects):
    """`built`: a finished build of the repository, tests included; `objects`: the build of library and unit tests with mutants."""
    library = f"{objects}/lib"
    library_of = (("ODE_MT_LIBRARY_DIR", library),)
    own, units = [], []
    for program in _programs(file):
        command = (f"{objects}/tests/{program}", "--gtest_brief=1", "--gtest_fail_fast")
        name = pathlib.Path(program).name
        wanted = _concept_filter(repository, program, file)
        if wanted:
            own.append(Suite(f"{name}: own tests", command + (f"--gtest_filter={wanted}",)))
        units.append(Suite(name, command + ((_FRAME_FILTER,) if name == "frame_tests" else ())))
    fuzz = (str(built / "tests/fuzz/odemt_fuzz"), "--ours", library)
    corpus = sorted(str(path) for path in (repository / "tests/fuzz/corpus").glob("*.script"))

    def exactness(name, themes, settings):
        wanted = ":".join(f"Exactness/{theme}/*.{setting}" for theme in dict.fromkeys(themes) for setting in settings)
        return Suite(name, (str(built / "tests/exactness/exactness_test"), "--gtest_brief=1", "--gtest_fail_fast",
                            f"--gtest_filter={wanted}"), library_of)

    drawn = [Suite("fuzz corpus", fuzz + ("--replay", *corpus)),
             Suite("fuzz, 150 drawn scripts", fuzz + ("--seed", "1", "--scripts", "150", "--until-difference")),
             exactness("exactness themes", _first(_THEMES, file) + _THEMES["ode_mt/"], _SETTINGS)]
    more = [Suite(pathlib.Path(program).name, (f"{objects}/tests/{program}", "--gtest_brief=1", "--gtest_fail_fast"))
            for program in _MORE_UNITS]
    more += [Suite(name, (str(built / f"tests/faults/{name}"), "--gtest_brief=1", "--gtest_fail_fast"), library_of)
            for name in ("allocation_test", "surroundings_test")]
    more.append(exactness("more exactness themes", _first(_MORE_THEMES, file) + _MORE_FRAME_THEMES, _MORE_SETTINGS))
    if file.startswith("ode_mt/api/"):
        more.append(Suite("every call", (str(built / "tests/kept_state/every_call_test"), "--gtest_filter=*.serial"), library_of))
    return own + units[:-1] + drawn + [units[-1]] + more
