#!/usr/bin/env python3
"""Case files against cases/case.schema.json: the shipped and the accepted small cases must pass, and
of the refused small cases those whose mistake a schema can see must fail, as the reader fails them.

usage: validate_cases.py SOURCE_DIR      exit code 0 or 1
"""
import json
import pathlib
import sys

import jsonschema
import yaml

# Mistakes that show only when names, files and numbers are put together (or that YAML's own readers
# let pass, such as a repeated key): the program refuses these, a schema cannot.
BEYOND_A_SCHEMA = {
    "below_the_seabed", "current_profile", "database", "displacement", "flex_without_stiffness",
    "free_end_a", "full_qtf", "guide_out_of_reach", "led_twice", "limp_clamp", "line_model",
    "lines_of_platforms", "loops", "missing_file", "no_platforms", "one_or_several", "one_point", "short_line", "stiffness_ratio", "tensioned_riser", "times",
    "two_lines_of_one_name", "unknown_names", "unknown_parameter",
}
# Read by Python in another way: not at all, with the last of two keys, `<<` carried out, yes as true.
NOT_YAML = {"tab", "not_yaml", "unquoted_parameter", "empty", "repeated_key", "merge_key",
            "not_boolean"}


def problems(validator, path):
    with open(path, encoding="utf-8") as file:
        return [error.message for error in validator.iter_errors(yaml.safe_load(file))]


def main():
    source = pathlib.Path(sys.argv[1])
    with open(source / "cases/case.schema.json", encoding="utf-8") as file:
        schema = json.load(file)
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    small = source / "tests/common/cases"
    wrong = 0
    good = [p for p in sorted(source.glob("cases/**/*.yml")) if p.parent.name != "line_types" and p.stem != "reference"]
    good += sorted(small.glob("accepted/*.yml"))
    for path in good:
        for message in problems(validator, path):
            print(f"{path}: should be accepted: {message}")
            wrong += 1
    bad = sorted(small.glob("refused/*.yml"))
    for path in bad:
        if path.stem in NOT_YAML:
            continue
        refused = bool(problems(validator, path))
        if refused != (path.stem not in BEYOND_A_SCHEMA):
            print(f"{path}: should be {'accepted' if refused else 'refused'} by the schema")
            wrong += 1
    print(f"{len(good)} good and {len(bad)} wrong cases, {wrong} disagreements")
    return 1 if wrong or not good or not bad else 0


if __name__ == "__main__":
    sys.exit(main())
