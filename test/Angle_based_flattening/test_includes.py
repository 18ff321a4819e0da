# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Each header includes the internal headers whose names it uses: test_includes.py SOURCE_FOLDER [--list].

A reader of C++ for our own style, not a compiler: it knows the names that an internal header gives to a namespace, and
looks for them in the other headers. Names that a header declares itself, also as a member or a parameter, are no uses, nor
are functions with the name of a member of any class. What implements a header (`x_impl.h`) may rely on what that includes.
--list prints the missing includes, and tests nothing.
"""

import re
import sys
import tempfile
import unittest
from pathlib import Path

BOOST_GRAPH = {"source", "target"}  # also found by the types of their arguments
NAMESPACES = {"CGAL", "Surface_mesh_parameterization", "SMP", "internal", "ABF", "abf"}
TYPE = re.compile(r"\b(?:class|struct|enum(?: class| struct)?|union)\s+(\w+)(?:\s+final)?(?=[^;()=]*$)")
ALIAS = re.compile(r"\busing\s+(\w+)\s*=")
TYPEDEF = re.compile(r"\btypedef\b.*\b(\w+)\s*$", re.S)
FUNCTION = re.compile(r"(?<![\w:])([a-z]\w*)\s*\(")
VARIABLE = re.compile(r"\b(?:const|constexpr)\b.*?\b(\w+)\s*$", re.S)
NO_FUNCTIONS = {"void", "if", "for", "while", "switch", "return", "sizeof", "decltype", "noexcept", "static_assert", "catch",
                "alignas", "operator", "defined"}


def code_of(text):
    """Without comments, literals and directives; but for the macros that are defined, which are a list"""
    text = re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', " ", text, flags=re.S)
    text = re.sub(r"\\\n", " ", text)
    macros = re.findall(r"^\s*#\s*define\s+(CGAL_\w+)[ (]+\S", text, flags=re.M)
    return re.sub(r"^\s*#.*$", "", text, flags=re.M), macros


def without_template(declaration):
    while (start := re.match(r"\s*template\s*<", declaration)) is not None:
        depth, end = 1, start.end()
        while depth > 0 and end < len(declaration):
            depth += {"<": 1, ">": -1}.get(declaration[end], 0)
            end += 1
        declaration = declaration[end:]
    return declaration


def names_in(declaration, is_body):
    """What a declaration at the level of a namespace names, or nothing: `is_body` if a brace follows it."""
    declaration = without_template(declaration)
    if is_body and "(" not in declaration and (found := TYPE.search(declaration)):
        yield found[1]
    elif found := ALIAS.search(declaration):
        yield found[1]
    elif found := TYPEDEF.search(declaration):
        yield found[1]
    elif (head := declaration.split("=")[0]) and "operator" not in head:
        if found := FUNCTION.search(head):
            if found[1] not in NO_FUNCTIONS and head[: found.start()].strip():
                yield found[1]
        elif found := VARIABLE.search(head):
            yield found[1]


def defined_names(text):
    """Those of namespaces, and those of functions that are members"""
    code, macros = code_of(text)
    names, members, scopes, begin = set(macros), set(), [], 0
    for at, character in ((found.start(), found[0]) for found in re.finditer(r"[{};]", code)):
        declaration = code[begin:at].strip()
        if character == "}":
            scopes.pop()
        elif all(scope == "namespace" for scope in scopes):
            is_namespace = character == "{" and re.search(r"\bnamespace\b[\w: ]*$", declaration) is not None
            if not is_namespace:
                names.update(names_in(declaration, character == "{"))
        elif scopes[-1] == "class":
            members.update(re.findall(r"[\w>&*]\s+[*&]?(\w+)\s*\(", without_template(declaration))[:1])
        if character == "{":
            head = without_template(declaration)
            scopes.append("namespace" if re.search(r"\bnamespace\b[\w: ]*$", head) else
                          "class" if re.search(r"\b(?:class|struct)\s+\w+[^()]*$", head) else "body")
        begin = at + 1
    return {name for name in names if len(name) > 2}, members


def used_names(text, names):
    code, _ = code_of(text)
    own = set(re.findall(r"\b(?:class|struct|typename|enum|union|using|namespace)\s+(\w+)", code))
    own.update(re.findall(r"\btypedef\b[^;]*\b(\w+)\s*;", code))
    own.update(re.findall(r"\b(?!return\b|else\b|throw\b)\w+[>&*]*\s+[*&]?([a-z]\w*)\s*[({=;,)]", code))
    used = set()
    for found in re.finditer(r"\w+", code):
        name = found[0]
        if name not in names or name in own:
            continue
        before, after = code[: found.start()].rstrip()[-60:], code[found.end() :].lstrip()[:1]
        if before.endswith((".", "->")):
            continue
        if before.endswith("::"):
            scope = re.search(r"(\w+)\s*::$", before)
            if scope is not None and scope[1] not in NAMESPACES:
                continue
        elif name[0].islower():
            if after not in ("(", "<"):  # a variable or a parameter
                continue
        used.add(name)
    return used


def missing_includes(root):
    """Pairs of a header and the headers, one of which it should include, with the name that it uses"""
    texts = {str(file.relative_to(root)): file.read_text() for file in sorted(root.rglob("*.h"))}
    defined = {header: defined_names(text) for header, text in texts.items()}
    of_members = set().union(*(members for _, members in defined.values()))
    places = {}
    for header, (names, _) in defined.items():
        for name in names - of_members - BOOST_GRAPH if "/internal/" in header else ():
            places.setdefault(name, set()).add(header)
    included = {header: set(re.findall(r"^\s*#\s*include\s*<([^>]+)>", text, flags=re.M)) | {header}
                for header, text in texts.items()}
    missing = []
    for header, text in texts.items():
        known = included[header] | included.get(header.replace("_impl.h", ".h"), set())
        for name in sorted(used_names(text, places.keys() - defined[header][0])):
            if not known & places[name]:
                missing.append((header, sorted(places[name]), name))
    return missing


class Includes(unittest.TestCase):
    def test_headers(self):
        for header, places, name in missing_includes(ROOT / "include"):
            with self.subTest(header=header):
                self.fail(f"{name} is from {' or '.join(places)}")

    def test_what_is_missing_is_found(self):
        with tempfile.TemporaryDirectory() as folder:
            internal = Path(folder) / "CGAL/internal"
            internal.mkdir(parents=True)
            (internal / "a.h").write_text("namespace A {\nstruct Box { int width; };\ntemplate <class T>\n"
                                          "inline int area(const Box& box) { return box.width; }\nclass Other;\n}\n")
            (internal / "b.h").write_text("#include <CGAL/internal/a.h>\nint b(Box x) { return area(x); } // Box\n")
            (internal / "c.h").write_text("struct Own { int area; void f() { area = 1; } Other o; };\n")
            (internal / "d.h").write_text("#include <CGAL/internal/b.h>\nint d(Box x) { return area(x); }\n")
            self.assertEqual(missing_includes(Path(folder)), [("CGAL/internal/d.h", ["CGAL/internal/a.h"], "Box"),
                                                              ("CGAL/internal/d.h", ["CGAL/internal/a.h"], "area")])


if __name__ == "__main__":
    ROOT = Path(sys.argv.pop(1)).resolve()
    if "--list" in sys.argv:
        for header, places, name in missing_includes(ROOT / "include"):
            print(f"{header}: {' or '.join(places)} ({name})")
    else:
        unittest.main()
