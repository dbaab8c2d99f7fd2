#!/usr/bin/env python3
"""A file of the timeline is what docs/tools.md says.

    check_trace.py FILE STEPS NAME...    valid JSON, with STEPS steps, none of which is dropped, and with events of these names
    check_trace.py --self-test           shows that files with defects are refused

Each event of a thread lies within another or beside it, and the stages directly within a step, and within a collision, take nine
tenths of its time at least. This holds for the median of them: on a busy machine some are interrupted between two stages.
"""
import json
import statistics
import sys

KINDS = {"X", "C", "M", "i"}
COVERED = 0.9


def complaints_of(trace, steps, names):
    events = trace["traceEvents"]
    for event in events:
        if event["ph"] not in KINDS:
            yield f"an event of an unknown kind: {event}"
        if event["ph"] == "X" and ("dur" not in event or event["dur"] < 0 or event["ts"] < 0):
            yield f"an event without a length: {event}"
    found = {event["name"] for event in events}
    for name in names:
        if name not in found:
            yield f"no {name}"
    spans = [event for event in events if event["ph"] == "X" and event.get("dur", -1) >= 0]
    count = sum(event["name"] == "step" for event in spans)
    if count != steps:
        yield f"{count} steps instead of {steps}"
    if trace["otherData"]["eventsDropped"] != 0:
        yield f"{trace['otherData']['eventsDropped']} events are dropped"
    named = {event["tid"] for event in events if event["name"] == "thread_name"}
    yield from (f"a thread without a name: {thread}" for thread in {event["tid"] for event in spans} - named)
    shares = {"step": [], "collide": []}
    for thread in {event["tid"] for event in spans}:
        around = []
        for event in sorted((e for e in spans if e["tid"] == thread), key=lambda e: (e["ts"], -e["dur"])):
            begin, end = event["ts"], event["ts"] + event["dur"]  # as viewers add them: sums must be exact
            while around and around[-1][1] <= begin:
                around.pop()
            if around and end > around[-1][1]:
                yield f"{event} reaches out of {around[-1][0]}"
            if around and around[-1][2]:
                around[-1][2][-1] += (end - begin) / around[-1][3]
            counted = shares.get(event["name"]) if end > begin else None
            if counted is not None:
                counted.append(0.0)
            around.append((event["name"], end, counted, end - begin))
    for name, values in shares.items():
        if values and statistics.median(values) < COVERED:
            yield f"what is within a {name} takes {statistics.median(values):.0%} of its time"


def self_test():
    def span(name, begin, length, thread=1):
        return {"name": name, "ph": "X", "tid": thread, "ts": begin, "dur": length}

    def trace(*events, dropped=0):
        thread = {"name": "thread_name", "ph": "M", "tid": 1}
        return {"traceEvents": [thread, *events], "otherData": {"eventsDropped": dropped}}

    def steps(interrupted):  # of three, 10 us each; `interrupted` of them have a gap of half their time
        for k in range(3):
            begin = 20 * k
            yield from (span("step", begin, 10), span("islands", begin, 5 if k < interrupted else 10))

    step = [span("island search", 0, 1), span("islands", 1, 9), span("step", 0, 10)]
    cases = {
        "right": (trace(*step), []),
        "without a length": (trace(*step, {"name": "island", "ph": "X", "tid": 1, "ts": 2}), ["an event without a length"]),
        "across": (trace(*step, span("island", 2, 9)), ["reaches out of"]),
        "a gap": (trace(step[0], step[2]), ["what is within a step", "no islands"]),
        "one interrupted": (trace(*steps(1)), ["3 steps instead of 1"]),
        "two interrupted": (trace(*steps(2)), ["3 steps instead of 1", "what is within a step"]),
        "dropped": (trace(*step, dropped=2), ["2 events are dropped"]),
        "two steps": (trace(*step, span("step", 20, 0)), ["2 steps instead of 1"]),
        "without a name": (trace(*step, span("island", 2, 1, thread=2)), ["a thread without a name"]),
    }
    for name, (given, expected) in cases.items():
        found = list(complaints_of(given, 1, ["islands"]))
        if len(found) != len(expected) or not all(any(words in line for line in found) for words in expected):
            yield f"{name}: {found}"


if __name__ == "__main__":
    if sys.argv[1] == "--self-test":
        complaints = list(self_test())
    else:
        with open(sys.argv[1], encoding="utf-8") as file:
            complaints = list(complaints_of(json.load(file), int(sys.argv[2]), sys.argv[3:]))
    for complaint in complaints:
        print(complaint)
    sys.exit(1 if complaints else 0)
