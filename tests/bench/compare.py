#!/usr/bin/env python3
"""Ratios of benchmark times, new over old: compare.py OLD.json NEW.json. Files are Google Benchmark's
(--benchmark_out=RUN.json) or trimmed: compare.py --trim RUN.json.. > baseline.json keeps names and nanoseconds per
particle, of the fastest of all runs in one or more files."""

import json
import statistics
import sys


def read(path):
    with open(path) as file:
        data = json.load(file)
    if "benchmarks" not in data:
        return data
    times = {}
    for run in data["benchmarks"]:
        if run.get("run_type", "iteration") == "iteration" and not run.get("error_occurred"):
            name = run["name"].split("/iterations:")[0].removesuffix("/manual_time")
            time = round(run["ns/particle"], 2)
            times[name] = min(times.get(name, time), time)
    return times


def main(arguments):
    if len(arguments) > 1 and arguments[0] == "--trim":
        least = {}
        for path in arguments[1:]:
            for name, time in read(path).items():
                least[name] = min(least.get(name, time), time)
        print(json.dumps(least, indent=0))
        return 0
    if len(arguments) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    old, new = map(read, arguments)
    both = [name for name in new if name in old]
    for name in both:
        print(f"{new[name] / old[name]:7.3f}  {name}")
    if both:
        print(f"{statistics.geometric_mean(new[name] / old[name] for name in both):7.3f}  geometric mean of {len(both)}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
