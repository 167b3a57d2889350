"""Validates the shipped cases against the JSON Schema of case files: check_schema.py SCHEMA SOURCE_DIRECTORY."""

import json
import pathlib
import sys
import tomllib

import jsonschema

# Bad cases whose mistake the schema alone can see; units, formulas and relations between keys are beyond it.
VISIBLE = [
    "choice_in_list", "choice_misspelt", "choice_unknown", "elements_vector", "kind_boolean", "kind_list_for_number",
    "kind_fraction_for_whole", "kind_negative_whole", "kind_number_for_text", "kind_table_for_list", "kind_value_for_table",
    "missing_end", "missing_diameter", "missing_in_list", "missing_tables", "name_unusable", "range_restitution", "range_zero",
    "unit_no_number", "unknown_key", "unknown_key_elsewhere", "unknown_nested_key", "unknown_table", "unknown_top_key",
]


def main():
    schema = json.loads(pathlib.Path(sys.argv[1]).read_text())
    source = pathlib.Path(sys.argv[2])
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    wrong = []
    good = [path for place in ("tests/good", "examples", "verify", "bench") for path in (source / place).rglob("*.toml")]
    for path in good:
        errors = list(validator.iter_errors(tomllib.loads(path.read_text())))
        wrong += [f"{path}: {list(error.path)}: {error.message[:200]}" for error in errors]
    for name in VISIBLE:
        path = source / "tests/bad" / (name + ".toml")
        if validator.is_valid(tomllib.loads(path.read_text())):
            wrong.append(f"{path}: the schema lets it pass")
    print("\n".join(wrong))
    return 1 if wrong or len(good) < 2 else 0


sys.exit(main())
