"""Sums up gcov's JSON: coverage.py INCLUDE_FOLDER COVERAGE_JSON, a document on each line of the file.

A line counts as run if any translation unit, or any instance of a template, ran it.
"""

import json
import os
import sys


def runs_of_lines(include, name):
    runs = {}
    with open(name, encoding="utf-8") as documents:
        for document in documents:
            unit = json.loads(document)
            for source in unit["files"]:
                path = os.path.realpath(os.path.join(unit["current_working_directory"], source["file"]))
                if not path.startswith(include + os.sep):
                    continue
                lines = runs.setdefault(os.path.relpath(path, include), {})
                for line in source["lines"]:
                    number = line["line_number"]
                    lines[number] = lines.get(number, 0) + line["count"]
    return runs


def ranges(numbers):
    """[3, 4, 5, 9] as 3-5 9"""
    text = []
    begin = end = None
    for number in numbers + [None]:
        if end is not None and number == end + 1:
            end = number
            continue
        if begin is not None:
            text.append(str(begin) if begin == end else f"{begin}-{end}")
        begin = end = number
    return " ".join(text)


def main():
    include = os.path.realpath(sys.argv[1])
    runs = runs_of_lines(include, sys.argv[2])
    all_lines = all_run = 0
    for name in sorted(runs):
        lines = runs[name]
        if not lines:
            continue
        missed = sorted(number for number, count in lines.items() if count == 0)
        all_lines += len(lines)
        all_run += len(lines) - len(missed)
        share = 100 * (len(lines) - len(missed)) / len(lines)
        print(f"{share:6.1f} %  {name}" + (f"  not run: {ranges(missed)}" if missed else ""))
    for folder, _, names in os.walk(include):
        for name in sorted(names):
            path = os.path.relpath(os.path.join(folder, name), include)
            if not runs.get(path):
                print(f"     -    {path}  no code that any test compiles")
    print(f"{100 * all_run / max(1, all_lines):6.1f} %  of {all_lines} lines")


if __name__ == "__main__":
    main()
