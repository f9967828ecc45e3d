# SPDX-License-Identifier: MIT
"""Loops of C source, and the bounds that stand beside them.

The language of the comments, which check_loops.py holds:

  /* bound: E words */     beside a loop: at most E rounds each time it is come to
  /* at most: E words */   beside a statement: it is executed at most E times each time
                           the innermost loop that it is in is come to
  /* bytes: E words */     beside memcpy or memset: the most that n is

E is an expression of integers, constants and sizeof(type) with + - * / and parentheses,
as the preprocessor and the compiler see it there; `= 32` after it says what it comes to.
Words, of small letters, say why.  Further clauses follow after `;`, each with a
place at its end for which it holds:

  E words in all rounds of the outer loop       the rounds added up
  E words in a call of NAME                     the same
  E words as GROUP in a call of NAME            the same, all of the group added up too
  E words each time in a call of NAME           each time, when that function is calling
  E words a time in a call of NAME              times E as often as it is come to, added up

NAME may be several, with `or` between; `through OTHER` after it leaves only what is executed
for a call of that function, inlined or not.
"""
import collections
import pathlib
import re

TOKEN = re.compile(r'/\*.*?\*/|//[^\n]*|"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])*\'', re.DOTALL)
COMMENT = re.compile(r"/\*\s*(bound|bytes|at most):\s*(.*?)\s*\*/", re.DOTALL)
HEAD = re.compile(r"\b(for|while)\s*\(|\bdo\s*\{")
_ATOM = r"\(*\s*(?:sizeof\(\w+\)|(?:\d+U?|[A-Z][A-Z0-9_]*)\b)(?:\s*\))*"
EXPRESSION = re.compile(rf"{_ATOM}(?:\s*[-+*/]\s*{_ATOM})*")
VALUE = re.compile(r"\s*=\s*(\d+)\b")
OUTER = re.compile(r"\bin all rounds of the outer loop$")
CALL = re.compile(r"(\b(?:each|a) time )?(?:\bas (\w+) )?\bin a call of (\w+(?: or \w+)*)"
                  r"(?: through (\w+))?$")
_SCOPES = {None: "total", "each time ": "each", "a time ": "mean"}
WORDS = re.compile(r"[a-z0-9 ,'()-]*$")

Clause = collections.namedtuple("Clause", "expression value scope names group through")
"""scope: entry (each time), outer (in all rounds of the outer loop), total, each or mean (in a
call of one of the functions `names`); value: what `= N` says; group: of a total, or None; through: the function through
which it is called, or None."""

Note = collections.namedtuple("Note", "kind first last clauses")
"""A comment: kind is bound, at most or bytes; its lines, from 1."""


class Loop:
    """A loop of the source: its head's lines, its lines, its bounds."""

    def __init__(self, path, head, lines, note):
        self.path, self.head, self.lines, self.note = path, head, lines, note
        self.parent = None

    @property
    def line(self):
        return self.head[0]

    def __repr__(self):
        return f"{self.path.name}:{self.line}"


class Malformed(Exception):
    """A comment or a loop that cannot be read."""


def without_comments(text):
    """The text with comments and literals blanked, line breaks kept."""
    return TOKEN.sub(lambda m: re.sub(r"[^\n]", " ", m.group()), text)


def read_clause(text):
    """One clause of a bound."""
    match = EXPRESSION.match(text)
    if not match or match.group().count("(") != match.group().count(")"):
        raise Malformed(f"`{text}` does not begin with an expression of constants")
    rest = text[match.end():]
    value = VALUE.match(rest)
    rest = rest[value.end() if value else 0:].strip()
    scope, names, group, through = "entry", (), None, None
    call, outer = CALL.search(rest), OUTER.search(rest)
    if outer:
        scope, rest = "outer", rest[:outer.start()]
    elif call:
        scope, group = _SCOPES[call.group(1)], call.group(2)
        names, through = tuple(call.group(3).split(" or ")), call.group(4)
        rest = rest[:call.start()]
    if not WORDS.match(rest):
        raise Malformed(f"`{rest}` after the expression: words only")
    return Clause(match.group().strip(), int(value.group(1)) if value else None, scope, names,
                  group, through)


_FIRST = {"bound": ("entry", "outer"), "bytes": ("entry",), "at most": ("entry", "total")}


def read_notes(text):
    """Every such comment of a file."""
    notes = []
    for match in COMMENT.finditer(text):
        kind = match.group(1)
        body = " ".join(re.sub(r"\n\s*\*", "\n", match.group(2)).split())
        first = text.count("\n", 0, match.start()) + 1
        try:
            clauses = tuple(read_clause(part.strip()) for part in body.split(";"))
            if clauses[0].scope not in _FIRST[kind]:
                raise Malformed("begin with the bound of each time")
        except Malformed as error:
            raise Malformed(f"line {first}: {kind}: {error}") from None
        notes.append(Note(kind, first, first + match.group().count("\n"), clauses))
    return notes


def _closing(code, at, pair):
    """Index behind what closes the bracket at `at`."""
    depth = 0
    for i in range(at, len(code)):
        depth += {pair[0]: 1, pair[1]: -1}.get(code[i], 0)
        if depth == 0:
            return i + 1
    raise Malformed("a bracket is not closed")


def _spans(code):
    """(begin, end of head, end) of each loop, as indexes; a do's head is its while."""
    spans, of_do = [], set()
    for match in HEAD.finditer(code):
        if match.start() in of_do:
            continue
        if match.group().startswith("do"):
            body_end = _closing(code, match.end() - 1, "{}")
            head = re.compile(r"\s*while\s*\(").match(code, body_end)
            if not head:
                raise Malformed("a do without its while")
            begin = code.index("while", body_end)
            of_do.add(begin)
            end = _closing(code, head.end() - 1, "()")
            spans.append((match.start(), (begin, end), end))
        else:
            head_end = _closing(code, match.end() - 1, "()")
            brace = re.compile(r"\s*\{").match(code, head_end)
            end = _closing(code, brace.end() - 1, "{}") if brace else code.index(";", head_end)
            spans.append((match.start(), (match.start(), head_end), end))
    return spans


def _note_of(notes, head, first):
    """The bound on a line of the head or on the line before; a do's may stand at
    either of its ends."""
    for line in (*range(head[0], head[1] + 1), head[0] - 1, first, first - 1):
        for note in notes:
            if note.kind == "bound" and note.first <= line <= note.last:
                return note
    return None


def read_loops(path):
    """The loops of a file, outer ones first, and its notes."""
    text = pathlib.Path(path).read_text()
    code, notes = without_comments(text), read_notes(text)

    def line_of(index):
        return code.count("\n", 0, index) + 1

    loops = []
    for begin, head, end in _spans(code):
        lines = (line_of(begin), line_of(end - 1))
        head_lines = (line_of(head[0]), line_of(head[1] - 1))
        loops.append(Loop(pathlib.Path(path), head_lines, lines,
                          _note_of(notes, head_lines, lines[0])))
    loops.sort(key=lambda loop: (loop.lines[0], -loop.lines[1]))
    for i, loop in enumerate(loops):
        for outer in reversed(loops[:i]):
            if outer.lines[0] <= loop.lines[0] and loop.lines[1] <= outer.lines[1]:
                loop.parent = outer
                break
    return loops, notes
