"""Tries the JSON Schema of scenes that ringlet prints.

    validate.py RINGLET [--plugin FILE]... [--accepts SCENE.json...] [--refuses BROKEN.json...]

The schema must be valid itself, accept every SCENE, and refuse every BROKEN scene; so must
`ringlet check`.
"""

import argparse
import json
import subprocess
import sys

import jsonschema


def printed_schema(ringlet, plugins):
    command = [ringlet, "describe", "--schema"]
    for plugin in plugins:
        command += ["--plugin", plugin]
    return json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout)


def load(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def check(ringlet, path):
    return subprocess.run(
        [ringlet, "check", path], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)


def accepted(validator, ringlet, path):
    result = check(ringlet, path)
    if result.returncode != 0:
        print(f"{path}: `ringlet check` says\n{result.stderr}")
        return False
    error = jsonschema.exceptions.best_match(validator.iter_errors(load(path)))
    if error is not None:
        print(f"{path}: the schema refuses it at {list(error.path)}: {error.message}")
    return error is None


def refused(validator, ringlet, path):
    result = check(ringlet, path)
    if result.returncode != 2:
        print(f"{path}: `ringlet check` returns {result.returncode}")
        return False
    if validator.is_valid(load(path)):
        print(f"{path}: the schema accepts it, but `ringlet check` says\n{result.stderr}")
        return False
    return True


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("ringlet")
    parser.add_argument("--plugin", action="append", default=[])
    parser.add_argument("--accepts", nargs="+", default=[])
    parser.add_argument("--refuses", nargs="+", default=[])
    options = parser.parse_args()

    schema = printed_schema(options.ringlet, options.plugin)
    kind = jsonschema.Draft202012Validator
    if schema["$schema"] != kind.META_SCHEMA["$id"]:
        sys.exit(f"'{schema['$schema']}' is not the draft that this script knows")
    kind.check_schema(schema)
    validator = kind(schema)
    results = [accepted(validator, options.ringlet, path) for path in options.accepts]
    results += [refused(validator, options.ringlet, path) for path in options.refuses]
    if not results or not all(results):
        sys.exit(f"{results.count(False)} of {len(results)} scenes are not judged as they should")
    print(f"{len(results)} scenes are judged as they should")


if __name__ == "__main__":
    main()
