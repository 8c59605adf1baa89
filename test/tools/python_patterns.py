# SPDX-License-Identifier: BSD-3-Clause
"""Finds expressions in Python sources. A pattern is an expression, in which _ stands for any expression:

_.name         an attribute of anything
package.name   a name of a package, however it is imported
f(key=_)       a call with this argument, and perhaps others
f(_, _)        a call with at least two positional arguments, or with *arguments
[], {}, _:_    any list, dictionary or slice
"""
import ast
import collections

ANYTHING = "_"
# Parts of an expression that must match, too. Of other expressions only the type is compared.
PARTS = {ast.BinOp: ("left", "op", "right"), ast.UnaryOp: ("op", "operand"), ast.Subscript: ("value", "slice")}


class Patterns:
    """@param patterns expressions as text"""

    def __init__(self, patterns):
        self._patterns = collections.defaultdict(list)
        for text in patterns:
            pattern = ast.parse(text, mode="eval").body
            self._patterns[_key(pattern, {})].append((text, pattern))

    def find(self, source, version):
        """Yields (line, pattern) of each match in a source. Raises SyntaxError if the version of Python does not accept it."""
        tree = ast.parse(source, feature_version=version)
        imports = list(_imports(tree))
        names = {local: bound for _, local, bound, _ in imports}
        for line, _, _, name in imports:
            yield from ((line, text) for node in ast.walk(ast.parse(name, mode="eval").body) for text in self._of(node, {}))
        for node in ast.walk(tree):
            yield from ((node.lineno, text) for text in self._of(node, names))

    def _of(self, node, names):
        """Patterns that an expression matches."""
        return [text for text, pattern in self._patterns.get(_key(node, names), []) if _matches(pattern, node, names)]


def _imports(tree):
    """Yields (line, local name, its full name, imported name): for `import os.path` these are os, os and os.path."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            for alias in node.names:
                first = alias.name.split(".")[0]
                yield node.lineno, alias.asname or first, alias.name if alias.asname else first, alias.name
        elif isinstance(node, ast.ImportFrom) and not node.level:
            for alias in node.names:
                name = node.module if alias.name == "*" else f"{node.module}.{alias.name}"
                yield node.lineno, alias.asname or alias.name, name, name


def _full_name(node, names):
    """The dotted name of an expression such as np.max, or None if it is another expression."""
    if isinstance(node, ast.Name):
        return names.get(node.id, node.id)
    if isinstance(node, ast.Attribute):
        before = _full_name(node.value, names)
        return before and f"{before}.{node.attr}"
    return None


def _key(node, names):
    """Equal for all expressions that may match: the last name, or the type."""
    if isinstance(node, ast.Call):
        return _key(node.func, names)
    if isinstance(node, ast.Subscript):
        return _key(node.value, names)
    if isinstance(node, ast.Attribute):
        return node.attr
    return (_full_name(node, names) or type(node).__name__).split(".")[-1]


def _matches(pattern, node, names):
    pattern, node = (each.value if type(each).__name__ == "Index" else each for each in (pattern, node))  # of Python 3.8
    if isinstance(pattern, (ast.Name, ast.Attribute)):
        return _matches_name(pattern, node, names)
    if type(pattern) is not type(node):
        return False
    if isinstance(pattern, ast.Call):
        return _matches_call(pattern, node, names)
    if isinstance(pattern, ast.Constant):
        return pattern.value == node.value
    return all(_matches(getattr(pattern, part), getattr(node, part), names) for part in PARTS.get(type(pattern), ()))


def _matches_name(pattern, node, names):
    wanted = _full_name(pattern, {})
    if wanted == ANYTHING:
        return True
    if wanted and not wanted.startswith(f"{ANYTHING}."):
        return _full_name(node, names) == wanted
    return isinstance(node, ast.Attribute) and node.attr == pattern.attr and _matches(pattern.value, node.value, names)


def _matches_call(pattern, node, names):
    given = {keyword.arg: keyword.value for keyword in node.keywords}
    enough = len(node.args) >= len(pattern.args) or any(isinstance(argument, ast.Starred) for argument in node.args)
    return (_matches(pattern.func, node.func, names) and enough and
            all(keyword.arg in given and _matches(keyword.value, given[keyword.arg], names) for keyword in pattern.keywords))
