# SPDX-License-Identifier: BSD-3-Clause
"""Tables in text files, as other programs export them: encoding, comments, separator, and decimal sign.

A table consists of a head (names, perhaps units in a row of their own) and rows with numbers. The head ends where the first
row with a number begins.
"""
import codecs
import csv
import re
from typing import NamedTuple, Optional

from .command import Failure

BYTE_ORDER_MARKS = ((codecs.BOM_UTF8, "utf-8-sig"), (codecs.BOM_UTF16_LE, "utf-16"), (codecs.BOM_UTF16_BE, "utf-16"))
BLANKS = None                             # separator: any number of blanks and tabs
SEPARATORS = ("\t", ";", ",", BLANKS)     # in the order of the trials: a comma may also be a decimal sign
HEAD = 100                                # largest number of lines of a head, without comments
COMMENT = re.compile(r"\s*(?:#(?!N/A)|%|!|//)")
NUMBER = re.compile(r"[+-]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eEdD][+-]?\d+)?", re.ASCII)
THOUSANDS = re.compile(r"[+-]?[1-9]\d{0,2},\d{3}", re.ASCII)  # 1,250 is 1.25 or 1250
MISSING = re.compile(r"[+-]?nan(?:\(\w*\))?|[+-]?1\.#(?:qnan|ind)\d*|#?n/a|na|null|-*", re.IGNORECASE)
QUOTED_OR_TITLE = re.compile(r'"[^"]*"|[\[(][^\])]*[\])]|[^\s\[("]+(?:\s*(?:\[[^\]]*\]|\([^)]*\)))?')


def read_text(path):
    """Text of a file in UTF-8, in UTF-16 with a byte order mark, or otherwise in Latin-1.

    @throw Failure if the file contains something else than text
    """
    with open(path, "rb") as file:
        data = file.read()
    encoding = next((name for mark, name in BYTE_ORDER_MARKS if data.startswith(mark)), None)
    try:
        text = data.decode(encoding or "utf-8")
    except UnicodeDecodeError:
        if encoding:
            raise Failure(f"{path}: has the byte order mark of {encoding}, but other contents") from None
        text = data.decode("latin-1")
    if "\0" in text:
        raise Failure(f"{path}: is not a text in UTF-8, Latin-1, or UTF-16 with a byte order mark; export the table as CSV")
    return text


class _Layout(NamedTuple):
    separator: Optional[str]
    head: list    # rows of titles: (number of the line, cells)
    begin: int    # index of the first line with a number
    fits: bool    # head and first row with a number have as many cells


class TextTable:
    """Rows of a table, as texts of its cells.

    path       of the file
    comments   lines that begin with #, %, ! or //, without these signs
    separator  between the cells of a line: one of SEPARATORS
    head       rows before the first row with a number: (number of the line, cells). If there are none, the last comments
               before it that have as many cells, at most two
    """

    def __init__(self, path):
        self.path = path
        lines = [(number, line) for number, line in enumerate(re.split(r"\r\n|\r|\n", read_text(path)), 1) if line.strip()]
        self.comments = [COMMENT.sub("", line, count=1) for _, line in lines if COMMENT.match(line)]
        self._lines = [(number, line) for number, line in lines if not COMMENT.match(line)]
        self._has_quotes = any('"' in line for _, line in self._lines)
        if not self._lines:
            raise Failure(f"{path}: empty")
        first = self._lines[0][0]
        above = [(number, COMMENT.sub("", line, count=1)) for number, line in lines if number < first]
        separators = SEPARATORS
        named = re.fullmatch(r"\s*sep=(.)\s*", self._lines[0][1])
        if named and len(self._lines) > 1:  # the first line names the separator, for Excel
            self._lines, separators = self._lines[1:], named.group(1)
        layout = self._best_layout(separators, above)
        self.separator, self.head, self._begin = layout.separator, layout.head, layout.begin

    def rows(self):
        """Yields each row with numbers: (number of the line, cells). Rows without any content are omitted.

        There are at least as many cells as titles. Cells that the line does not have are empty.

        @throw Failure if a row has more cells than the head; with blanks as separator, also if it has less
        """
        width = self.width
        for number, cells in self._cells(self._lines[self._begin:], self.separator):
            if len(cells) != width:
                self._check_width(number, cells)
                cells += [""] * (width - len(cells))
            if any(cells):
                yield number, cells

    def decimal_sign(self, indices):
        """Decimal sign of the numbers in the columns with these indices: "." or ",".

        @throw Failure if both occur, or if the comma may also separate thousands
        """
        if self.separator == "," and not self._has_quotes:
            return "."
        return _decimal_sign((cells[index] for _, cells in self.rows() for index in indices), self.path)

    @property
    def width(self):
        """Number of titles, with those that are empty. A row with units may be shorter than that of the names."""
        return max((len(cells) for _, cells in self.head[-1 if self.separator is BLANKS else -2:]), default=0)

    def _check_width(self, number, cells):
        count = _width(cells)
        if count > self.width or (self.separator is BLANKS and count < self.width):
            raise Failure(f"{self.path}:{number}: the number of cells is {count}, must be {self.width} as in the titles"
                          f"{self._hint()}")

    def _hint(self):
        if self.separator == ",":
            return "; decimal commas require another separator: export it with semicolons or tabs, or with decimal points"
        return "; a table with empty cells requires a separator such as a semicolon" if self.separator is BLANKS else ""

    def _best_layout(self, separators, above):
        """Layout with the first separator that divides head and first row into as many cells, or else occurs in the head."""
        found, failure = [], None
        for separator in separators:
            occurs = separator is BLANKS or separator in self._lines[0][1]
            try:
                layout = self._layout(separator, above)
            except Failure as error:
                failure = failure or (error if occurs else None)
                continue
            if layout.fits:
                return layout
            if occurs:
                found.append(layout)
        if failure or not found:
            raise failure or Failure(f"{self.path}: none of its separators (comma, semicolon, tab, blanks) divides its lines")
        return found[0]

    def _layout(self, separator, above):
        """Layout with this separator.

        @param above comments above the first line: the head, if the first line has numbers
        @throw Failure if the lines cannot be divided by it
        """
        head, first = [], None
        for number, cells in self._cells(self._lines[:HEAD], separator):
            if any(NUMBER.fullmatch(cell) for cell in cells):
                first = cells
                break
            head.append((number, cells))
        begin = len(head)
        if not head:
            head = [row for row in self._cells(above, separator, True) if len(row[1]) == len(first)][-2:]
        return _Layout(separator, head, begin, bool(first and head) and _fit(head[-1][1], first, separator))

    def _cells(self, lines, separator, is_head=False):
        """Yields (number of the line, cells without blanks at their ends) for each line."""
        if separator is BLANKS:
            for number, line in lines:
                yield number, _blank_cells(line, is_head)
            return
        reader = csv.reader((line for _, line in lines), delimiter=separator, skipinitialspace=True, strict=True)
        count, number = 0, 0
        try:
            for number, _ in lines:
                cells = next(reader)
                count += 1
                if reader.line_num != count:
                    raise csv.Error("a quotation mark is not closed")
                yield number, [cell.strip() for cell in cells]
        except csv.Error as error:
            raise Failure(f"{self.path}:{number}: {error}") from None


def _width(cells):
    """Number of cells up to the last one that is not empty."""
    return max((i for i, cell in enumerate(cells, 1) if cell), default=0)


def _fit(titles, cells, separator):
    if separator is BLANKS:
        return len(titles) == len(cells)
    return len(titles) > 1 and _width(titles) <= len(cells) and _width(cells) <= len(titles)


def _blank_cells(line, is_head):
    """Cells of a line with blanks as separator. A blank before the unit of a title does not separate."""
    cells = line.split()
    if is_head or not any(NUMBER.fullmatch(cell) for cell in cells):
        titles = QUOTED_OR_TITLE.findall(re.sub(r"\s*/\s*", "/", line))
        if re.sub(r"\s", "", "".join(titles)) == re.sub(r"\s", "", line):
            return [title.strip('"').strip() for title in titles]
    return cells


def _decimal_sign(cells, path):
    example = {}
    for cell in cells:
        for sign in ".,":
            if sign in cell and ("sure" not in example or sign not in example) and NUMBER.fullmatch(cell):
                example.setdefault(sign, cell)
                if sign == "." or not THOUSANDS.fullmatch(cell):
                    example.setdefault("sure", cell)
    if "." in example and "," in example:
        raise Failure(f"{path}: '{example['.']}' has a decimal point and '{example[',']}' a comma; export it with one decimal "
                      "sign and without separators of thousands")
    if "," in example and "sure" not in example:
        raise Failure(f"{path}: '{example[',']}' has a decimal comma or a separator of thousands; --decimal-comma selects the "
                      "first, otherwise export it without separators of thousands")
    return "," if "," in example else "."


def number_text(cell, sign):
    """Number of a cell, as float() and decimal.Decimal() read it; "" if the cell is empty, NaN, NA or the like.

    @throw ValueError if the cell contains something else
    """
    if MISSING.fullmatch(cell):
        return ""
    text = cell.replace("\u2212", "-")
    if not NUMBER.fullmatch(text) or (sign == "." and "," in text) or (sign == "," and "." in text):
        raise ValueError(f"'{cell}' is not a number with a decimal {'comma' if sign == ',' else 'point'}")
    return re.sub("[dD]", "e", text.replace(",", "."))
