"""conformance_schema: a small validator for the part of JSON Schema (draft 2020-12) that golden/conformance/schema.json uses, and what a schema
cannot say."""
import json
import re

KNOWN = {"$schema", "$defs", "$ref", "title", "description", "type", "required", "additionalProperties", "properties", "const", "enum", "items",
         "minItems",
         "pattern", "minLength", "dependentRequired"}
TYPES = {"object": dict, "array": list, "string": str}


def faults(value, schema, root, at="the file"):
    """Sentences about what is not as the schema says."""
    unknown = set(schema) - KNOWN
    assert not unknown, "a keyword this validator does not know: %s" % unknown
    if "$ref" in schema:
        yield from faults(value, root["$defs"][schema["$ref"].removeprefix("#/$defs/")], root, at)
    if "type" in schema and not isinstance(value, TYPES[schema["type"]]):
        yield "%s is no %s" % (at, schema["type"])
        return
    if "const" in schema and (value != schema["const"] or type(value) is not type(schema["const"])):
        yield "%s is not %s" % (at, schema["const"])
    if "enum" in schema and value not in schema["enum"]:
        yield "%s is none of the words there are: %s" % (at, value)
    if isinstance(value, str):
        if len(value) < schema.get("minLength", 0):
            yield "%s is too short" % at
        if "pattern" in schema and not re.search(schema["pattern"], value):
            yield "%s does not look as it should: %s" % (at, value)
    if isinstance(value, list):
        if len(value) < schema.get("minItems", 0):
            yield "%s has too few items" % at
        for k, item in enumerate(value):
            yield from faults(item, schema.get("items", {}), root, "%s[%d]" % (at, k))
    if isinstance(value, dict):
        yield from members(value, schema, root, at)


def members(value, schema, root, at):
    for name in schema.get("required", []):
        if name not in value:
            yield "%s has no %s" % (at, name)
    for name, item in value.items():
        if name in schema.get("properties", {}):
            yield from faults(item, schema["properties"][name], root, "%s.%s" % (at, name))
        elif schema.get("additionalProperties", True) is False:
            yield "%s has a member %s that nothing has" % (at, name)
        for other in schema.get("dependentRequired", {}).get(name, []):
            if other not in value:
                yield "%s has %s, but no %s" % (at, name, other)


def number(text):
    return float.fromhex(text) if "x" in text or "inf" in text else float(text)


def unsaid(document):
    """What the schema cannot say: lists of one length, ids and requests of their own, an answer only where there is one."""
    ids, requests = set(), set()
    for v in document["vectors"]:
        lengths = {len(v[k]) for k in ("want", "bound", "want_left", "bound_left") if k in v}
        if len(lengths) > 1:
            yield "%s: lists of different lengths" % v["id"]
        if not v["id"].startswith("%s/%s/" % (document["operation"], v["category"])):
            yield "%s: operation and category are others" % v["id"]
        if v["id"] in ids or v["request"] in requests:
            yield "%s: is there twice" % v["id"]
        if v["validity"] == "invalid" and "want" in v:
            yield "%s: an invalid request has a right answer" % v["id"]
        if v["validity"] == "valid" and "want" not in v and document["operation"] != "approximate":
            yield "%s: a valid request has none" % v["id"]
        if number(v.get("condition", "0x1p+0")) < 1:
            yield "%s: a condition below 1" % v["id"]
        ids.add(v["id"])
        requests.add(v["request"])


def check(paths, schema_path):
    """Prints a line a file; whether all are as they should be, and how many vectors of each category there are."""
    with open(schema_path, encoding="utf-8") as f:
        schema = json.load(f)
    count, good = {}, True
    for path in paths:
        with open(path, encoding="utf-8") as f:
            document = json.load(f)
        wrong = list(faults(document, schema, schema))
        wrong = wrong or list(unsaid(document))
        good = good and not wrong
        print("%s %s: %s" % ("FAIL" if wrong else "ok", path, wrong[0] if wrong else "%d vectors, as the schema says" % len(document["vectors"])))
        for v in document.get("vectors", []):
            count[v.get("category")] = count.get(v.get("category"), 0) + 1
    return good, count


def bites(schema_path):
    """The validator itself: documents that are wrong in one place each are found to be."""
    with open(schema_path, encoding="utf-8") as f:
        schema = json.load(f)
    good = {"id": "span/plain/1", "category": "plain", "validity": "valid", "request": "1", "want": ["1"], "bound": ["0x0p+0"], "condition": "0x1p+0"}

    def document(**change):
        v = {k: x for k, x in {**good, **change}.items() if x is not None}
        return {"format": "etalon-conformance", "version": 1, "operation": "span", "vectors": [v]}
    changes = [{"id": "x"}, {"category": "other"}, {"validity": "good"}, {"request": None}, {"request": ""}, {"want": None}, {"want": []},
               {"want": [1]},
               {"want": ["1.5"]}, {"want": ["nan"]}, {"bound": ["-0x1p+0"]}, {"bound": None}, {"condition": None}, {"issue": "117"}, {"comment": ""},
               {"more": "1"}, {"want_left": ["1"]}, {"bound_left": ["0x0p+0"]}]
    bad = [document(**c) for c in changes]
    bad += [{**document(), "version": 2}, {**document(), "version": True}, {**document(), "operation": "spam"}, {**document(), "vectors": []},
            {**document(), "more": 1}, []]
    return not list(faults(document(), schema, schema)) and all(list(faults(d, schema, schema)) for d in bad)
