"""What the checks of this folder have in common."""
import sys


def run_check(complaints_of, failed_self_tests):
    """Prints what the arguments, folders and programs, are complained of, or, after --self-test, which cases are not found; exits with 1 for any."""
    complaints = list(failed_self_tests() if sys.argv[1] == "--self-test" else complaints_of(*sys.argv[1:]))
    for complaint in complaints:
        print(complaint)
    sys.exit(1 if complaints else 0)


def unexpected(found_of, cases):
    """Yields a line for each case, by name: (what is given, what is expected), for which another thing is found."""
    for name, (given, expected) in cases.items():
        found = found_of(given)
        if found != expected:
            yield f"{name}: expected {expected}, found {found}"
