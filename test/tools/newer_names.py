# SPDX-License-Identifier: BSD-3-Clause
"""Rules of newer_names.yaml, and what they find in a source."""
import collections
import re

from python_patterns import Patterns

# Comments and strings. A ' between digits separates thousands.
CPP_NOISE = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<!\w)\'(?:\\.|[^\'\\\n])+\'', re.DOTALL)
BUILD_NOISE = re.compile(r"(?:^|(?<=\s))#.*", re.MULTILINE)

Rule = collections.namedtuple("Rule", "software since refuse use bad of")
Finding = collections.namedtuple("Finding", "line name rule")  # no rule: syntax that the oldest Python does not accept


def version(text):
    return tuple(int(part) for part in text.split("."))


def rules_of(languages):
    """Rules by language, from the content of the file."""
    return {language: [Rule(software, since, entry["refuse"], entry["use"], entry.get("bad", []), entry.get("of"))
                       for software, versions in content.items() for since, entries in versions.items() for entry in entries]
            for language, content in languages.items()}


def finder(language, rules, python):
    """@param python the oldest version of Python. @return object with the method find(text, related)"""
    return PythonFinder(rules, python) if language == "python" else TextFinder(language, rules)


class PythonFinder:
    def __init__(self, rules, python):
        self._rules = {pattern: rule for rule in rules for pattern in rule.refuse}
        self._patterns, self._python = Patterns(self._rules), python

    def find(self, text, related=""):
        """Yields a Finding for each match."""
        try:
            for line, pattern in self._patterns.find(text, self._python):
                yield Finding(line, pattern, self._rules[pattern])
        except SyntaxError as error:
            yield Finding(error.lineno, "syntax", None)


class TextFinder:
    def __init__(self, language, rules):
        self._noise, self._rules = CPP_NOISE if language == "cpp" else BUILD_NOISE, rules

    def find(self, text, related=""):
        """Yields a Finding for each match.

        @param related text of the header of a source, or of the source of a header
        """
        text, related = self._without_noise(text), self._without_noise(related)
        for rule in self._rules:
            for expression in _expressions(rule, text + related):
                for number, line in enumerate(text.split("\n"), 1):
                    yield from (Finding(number, match.group().strip(), rule) for match in expression.finditer(line))

    def _without_noise(self, text):
        return self._noise.sub(lambda match: "\n" * match.group().count("\n"), text)


def _expressions(rule, text):
    """Compiled expressions of a rule. In them, NAME stands for the names that `rule.of` finds in the text."""
    names = "|".join(sorted(set(re.findall(rule.of, text)))) if rule.of else ""
    if names or not rule.of:
        for pattern in rule.refuse:
            yield re.compile(pattern.replace("NAME", f"(?:{names})"))


def faults_of_rules(rules, oldest):
    """Yields the rules that are not needed, that miss a bad sample, or whose expressions find none."""
    for language, rule in ((language, rule) for language, content in rules.items() for rule in content):
        where = f"newer_names.yaml: {rule.software} {rule.since}"
        if rule.software not in oldest:
            yield f"{where}: {rule.software} is not in the table of doc/platforms.md"
        elif version(rule.since) <= oldest[rule.software]:
            yield f"{where}: {rule.refuse[0]}: the oldest supported version has this name; remove the entry"
        for pattern in rule.refuse:
            alone = finder(language, [rule._replace(refuse=[pattern])], oldest["Python"])
            # A pattern for Python is an expression that it finds.
            if not any(list(alone.find(text)) for text in ([pattern] if language == "python" else rule.bad)):
                yield f"{where}: {pattern} finds none of its samples"
        for text in rule.bad:
            if not list(finder(language, [rule], oldest["Python"]).find(text)):
                yield f"{where}: does not find {text}"


def faults_of_samples(finders, samples):
    """Yields the samples in which more or less is found than they state."""
    for language, content in samples.items():
        for sample in content:
            found = [f"{finding.line} {finding.name}" for finding in finders[language].find(sample["code"])]
            if found != sample["finds"]:
                yield f"newer_names.yaml: in the sample {sample['code']!r} was found {found}"
