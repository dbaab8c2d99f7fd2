"""The suites that mutants have to pass, quickest first, by the folder that a mutant is in.

Programs that run on the shared library are those of a finished build; they find the mutant's library by a variable or an
option. Programs that are linked with objects or with libode.a are linked again, with the command that CMake wrote for them.
"""
import dataclasses
import pathlib
import re
import shlex

# By the start of the file's path: programs that are linked with the library's inside.
_UNITS = {
    "ode_mt/collision/": ["collision/search_parts_tests"],
    "ode_mt/clustering/": ["clustering/clustering_tests"],
    "ode_mt/dynamics/": ["dynamics/lcp_tests", "dynamics/dynamics_tests"],
    "ode_mt/heuristics/": ["heuristics/heuristics_tests"],
    "ode_mt/simd/": ["dynamics/lcp_tests", "dynamics/dynamics_tests", "collision/search_parts_tests"],
    "ode_mt/threading/": ["threading/threading_tests"],
    "ode_mt/": ["frame/frame_tests"],  # and for all others, last of all suites
}

# Themes of the exactness suite that play most of a folder's code, and in which settings.
_THEMES = {
    "ode_mt/collision/": ["space_churn", "hash_levels", "sleeping_crowds", "arrays_in_callbacks"],
    "ode_mt/clustering/": ["space_churn", "stray_geoms"],
    "ode_mt/dynamics/": ["powered_stops", "many_rows", "large_exact_islands", "singular_islands"],
    "ode_mt/api/": ["creation", "geom_ownership", "messages", "random_stream"],
    "ode_mt/": ["moved_callbacks", "several_worlds", "callback_liberties", "user_threading"],
}
_SETTINGS = ["pthread_0", "pthread_3", "lcp_*", "decluster_*"]


# Long ones of the frame's: what they show, the others show, too.
_FRAME_FILTER = "--gtest_filter=-*Progress*:*Fork*:*ManyWorlds*:*Exits*:*End*:*Unload*:*Restep*"


@dataclasses.dataclass(frozen=True)
class Suite:
    name: str
    command: tuple
    environment: tuple = ()  # pairs


def _first(table, file):
    return next(value for start, value in table.items() if file.startswith(start))


def _programs(file):
    return list(dict.fromkeys(_first(_UNITS, file) + _UNITS["ode_mt/"]))


def _linked(program, objects):
    return objects / "tests" / pathlib.Path(program).name


def _concept_filter(repository, program, file):
    """A filter for the tests of the mutant's concept (dxRankSort: rank_sort_test.cpp), or None."""
    concept = re.sub(r"(?<!^)(?=[A-Z])", "_", pathlib.Path(file).stem.removeprefix("dx")).lower()
    path = repository / "tests" / pathlib.Path(program).parent / f"{concept}_test.cpp"
    if not path.exists():
        return None
    suites = set(re.findall(r"^(?:TYPED_)?TEST(?:_[FP])?\((\w+),", path.read_text(), flags=re.M))
    return ":".join(f"*{suite}*" for suite in sorted(suites)) or None


def links_for(file, built, objects):
    """Pairs of folder and command that link the units of a file with the library of the build `objects`, not of `built`."""
    links = []
    for program in _programs(file):
        folder = built / "tests" / pathlib.Path(program).parent
        words = shlex.split((folder / "CMakeFiles" / f"{pathlib.Path(program).name}.dir/link.txt").read_text())
        ours = [re.sub(r"^\.\./\.\./(lib|ode_mt)/", f"{objects}/\\1/", word) for word in words]
        ours = [re.sub(r"^-Wl,-rpath,.*/lib$", f"-Wl,-rpath,{objects}/lib", word) for word in ours]
        ours[ours.index("-o") + 1] = str(_linked(program, objects))
        links.append((str(folder), tuple(ours)))
    return links


def suites_for(file, repository, built, objects):
    """`built`: a finished build of the repository, tests included; `objects`: the build that mutants are compiled in."""
    library = f"{objects}/lib"
    own, units = [], []
    for program in _programs(file):
        command = (str(_linked(program, objects)), "--gtest_brief=1", "--gtest_fail_fast")
        name = pathlib.Path(program).name
        wanted = _concept_filter(repository, program, file)
        if wanted:
            own.append(Suite(f"{name}: own tests", command + (f"--gtest_filter={wanted}",)))
        units.append(Suite(name, command + ((_FRAME_FILTER,) if name == "frame_tests" else ())))
    fuzz = (str(built / "tests/fuzz/odemt_fuzz"), "--ours", library)
    corpus = sorted(str(path) for path in (repository / "tests/fuzz/corpus").glob("*.script"))
    themes = list(dict.fromkeys(_first(_THEMES, file) + _THEMES["ode_mt/"]))
    wanted = ":".join(f"Exactness/{theme}/*.{setting}" for theme in themes for setting in _SETTINGS)
    exactness = Suite("exactness themes", (str(built / "tests/exactness/exactness_test"), "--gtest_brief=1", "--gtest_fail_fast",
                                           f"--gtest_filter={wanted}"), (("ODE_MT_LIBRARY_DIR", library),))
    drawn = [Suite("fuzz corpus", fuzz + ("--replay", *corpus)),
             Suite("fuzz, 150 drawn scripts", fuzz + ("--seed", "1", "--scripts", "150"))]
    return own + units[:-1] + drawn + [exactness, units[-1]]
