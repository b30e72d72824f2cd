"""Writes mutants into sources: those of a sample are compiled in, and the one that ABRAZO_MUTANT names is switched on."""

import json
import pathlib
import re
import shlex
import sys

from clang.cindex import CursorKind as K, Index, TokenKind, TranslationUnit, TypeKind as T

RELATIONS = {"<": "less", "<=": "less_equal", ">": "greater", ">=": "greater_equal", "==": "equal", "!=": "not_equal"}
SUMS = {"+": "plus", "-": "minus", "*": "times", "/": "divides"}
NUMBERS = {T.INT, T.UINT, T.LONG, T.ULONG, T.LONGLONG, T.ULONGLONG, T.FLOAT, T.DOUBLE}
FUNCTIONS = {K.FUNCTION_DECL, K.CXX_METHOD, K.CONSTRUCTOR, K.DESTRUCTOR, K.CONVERSION_FUNCTION, K.FUNCTION_TEMPLATE}
CONSTANT = {K.STATIC_ASSERT, K.CASE_STMT, K.ENUM_DECL, K.ENUM_CONSTANT_DECL, K.TYPE_REF, K.TEMPLATE_REF}
NAME = "::abrazo_mutation::"


class Mutants:
    def __init__(self):
        self.rows = []

    def add(self, file, cursor, kind, text):
        start = cursor.extent.start
        self.rows.append((len(self.rows), file, start.line, start.column, kind, " ".join(text.split())[:160]))
        return len(self.rows) - 1


class File:
    """The insertions of one file, each with the number of its mutant. At one place the ends of what is inside come first,
    then beginnings from outside in."""

    def __init__(self, path, name, mutants):
        self.path, self.name, self.mutants = path, name, mutants
        self.source = path.read_bytes()
        self.edits = []

    def text(self, cursor):
        return self.source[cursor.extent.start.offset : cursor.extent.end.offset].decode(errors="replace")

    def wrap(self, cursor, before, after):
        start, end = cursor.extent.start.offset, cursor.extent.end.offset
        self.insert((start, 1, -(end - start), len(self.edits), 0, before))
        self.insert((end, 0, end - start, -len(self.edits), 0, after))

    def replace(self, offset, length, text):
        self.insert((offset, 2, 0, 0, length, text))

    def insert(self, edit):
        """Of the mutant that was added last."""
        self.edits.append((*edit, len(self.mutants.rows) - 1))

    def write(self, chosen):
        out, at = [], 0
        for offset, _, _, _, length, text, number in sorted(self.edits, key=lambda edit: edit[:4]):
            if number not in chosen:
                continue
            out += [self.source[at:offset], text.encode()]
            at = offset + length
        self.path.write_bytes(b"".join(out) + self.source[at:])

    def operator(self, cursor):
        """Offset and spelling of the operator between the two operands, None where a macro stands between."""
        children = list(cursor.get_children())
        if len(children) != 2:
            return None
        left, right = children
        between = self.source[left.extent.end.offset : right.extent.start.offset].decode(errors="replace")
        found = re.fullmatch(r"\s*(<=>|<=|>=|==|!=|&&|\|\||[-+*/<>])\s*", between)
        if not found:
            return None
        return left.extent.end.offset + found.start(1), found.group(1), left, right

    def binary(self, cursor):
        found = self.operator(cursor)
        if not found:
            return
        offset, sign, left, right = found
        text = self.text(cursor)
        if sign in RELATIONS:
            name, kind = RELATIONS[sign], "relation"
        elif sign in SUMS:
            if cursor.type.get_canonical().kind not in NUMBERS:
                return
            if any(child.type.get_canonical().kind not in NUMBERS for child in (left, right)):
                return
            name, kind = SUMS[sign], "arithmetic"
        elif sign in ("&&", "||"):
            for operand in (left, right):
                id = self.mutants.add(self.name, operand, "operand left out", self.text(operand) + " of " + text)
                alternative = f" || {NAME}on({id}))" if sign == "&&" else f" && !{NAME}on({id}))"
                self.wrap(operand, "((", ")" + alternative)
            return
        else:
            return
        id = self.mutants.add(self.name, cursor, kind, text)
        self.wrap(cursor, f"{NAME}{name}({id}, ", ")")
        self.replace(offset, len(sign), ",")

    def condition(self, cursor):
        id = self.mutants.add(self.name, cursor, "condition negated", self.text(cursor))
        self.wrap(cursor, f"({NAME}on({id}) != bool(", "))")

    def statement(self, cursor):
        end = cursor.extent.end.offset
        after = re.match(rb"\s*;", self.source[end:])
        if not after:
            return
        id = self.mutants.add(self.name, cursor, "statement left out", self.text(cursor))
        self.insert((cursor.extent.start.offset, 1, -(end - cursor.extent.start.offset) - 1, 0, 0, f"if (!{NAME}on({id})) {{ "))
        self.insert((end + after.end(), 0, 1 << 30, 0, 0, " }"))


def is_macro(cursor, macros):
    start, end = cursor.extent.start.offset, cursor.extent.end.offset
    return any(a < end and start < b for a, b in macros)


def visit(cursor, file, path, macros, inside):
    for child in cursor.get_children():
        place = child.location.file
        if child.kind != K.TRANSLATION_UNIT and (place is None or place.name != path):
            if child.kind in (K.UNEXPOSED_EXPR, K.NAMESPACE, K.UNEXPOSED_DECL, K.LINKAGE_SPEC) and place is None:
                visit(child, file, path, macros, inside)
            continue
        if child.kind in CONSTANT:
            if child.kind == K.CASE_STMT:  # its constant stays, its statement is looked at
                for part in list(child.get_children())[1:]:
                    visit_one(part, file, path, macros, inside, child)
            continue
        visit_one(child, file, path, macros, inside, cursor)


def visit_one(child, file, path, macros, inside, parent):
    kind = child.kind
    if kind in FUNCTIONS:
        head = file.text(child).split("{")[0]
        if "constexpr" in head or "consteval" in head:
            return
        visit(child, file, path, macros, child.is_definition())
        return
    if kind == K.LAMBDA_EXPR:
        visit(child, file, path, macros, True)
        return
    if kind == K.VAR_DECL and ("constexpr" in file.text(child) or "static const" in file.text(child)):
        return
    if kind == K.IF_STMT and re.match(r"if\s+constexpr", file.text(child)):
        for part in list(child.get_children())[1:]:
            visit_one(part, file, path, macros, inside, child)
        return
    if kind == K.PARM_DECL:
        return
    clean = inside and not is_macro(child, macros)
    if clean and kind == K.BINARY_OPERATOR:
        file.binary(child)
    if clean and parent.kind == K.COMPOUND_STMT and kind in (K.CALL_EXPR, K.COMPOUND_ASSIGNMENT_OPERATOR, K.UNARY_OPERATOR, K.BINARY_OPERATOR):
        file.statement(child)
    if clean and kind == K.IF_STMT:
        parts = list(child.get_children())
        condition = parts[0]
        whole = file.source[child.extent.start.offset : condition.extent.start.offset]
        is_plain = re.fullmatch(rb"if\s*\(\s*", whole) and condition.kind not in (K.VAR_DECL, K.DECL_STMT, K.BINARY_OPERATOR)
        if is_plain and condition.type.get_canonical().kind == T.BOOL and not is_macro(condition, macros):
            file.condition(condition)
    visit(child, file, path, macros, inside)


def arguments(commands, tree):
    """What the compiler is told about core, in compile_commands.json of a build folder inside TREE."""
    for entry in json.loads(commands.read_text()):
        if "abrazo_core" not in entry["command"] or "/core/" not in entry["command"]:
            continue
        words, kept = shlex.split(entry["command"]), []
        for i, word in enumerate(words):
            if word in ("-isystem", "-I"):
                kept += words[i : i + 2]
            elif word.startswith(("-I", "-D")):
                kept.append(word)
        return [*kept, "-std=gnu++20", "-x", "c++"]
    raise SystemExit(f"{commands} has no command for core")


def write(tree, flags_of, folders, draw):
    """Changes the sources of FOLDERS below TREE in place.

    Rows of all mutants (number, file, line, column, kind, text) go to DRAW; those that it returns are written and returned.
    """
    index, mutants, files = Index.create(), Mutants(), []
    flags = arguments(flags_of, tree)
    for folder in folders:
        for path in sorted((tree / folder).rglob("*.cpp")):
            unit = index.parse(str(path), flags, options=TranslationUnit.PARSE_DETAILED_PROCESSING_RECORD)
            errors = [found for found in unit.diagnostics if found.severity >= 3]
            if errors:
                print(f"{path.relative_to(tree)}: left out, {errors[0].spelling}", file=sys.stderr)
                continue
            macros = [
                (found.extent.start.offset, found.extent.end.offset)
                for found in unit.cursor.get_children()
                if found.kind == K.MACRO_INSTANTIATION and found.location.file and found.location.file.name == str(path)
            ]
            file = File(path, str(path.relative_to(tree)), mutants)
            visit(unit.cursor, file, str(path), macros, False)
            files.append(file)
    rows = draw(mutants.rows)
    for file in files:
        file.write({row[0] for row in rows})
    return rows
