"""A strict reader and interpreter of the part of IEC 61131-3 Structured Text that cgw writes.

Whatever is not in that part is an error, and so is what a strict compiler refuses: words of the language as names, names
with double, leading or trailing underscores or longer than 64 characters, names that meet (case does not matter), mixed
types without a conversion, characters beyond ASCII, comments in comments. REAL is computed in 32 bits, every operation rounded.
"""
import re
import struct

WORDS = set("""
ABS ACOS ADD AND ANY ANY_INT ANY_NUM ANY_REAL ANY_BIT ARRAY ASIN AT ATAN BOOL BY BYTE CASE CONCAT CONFIGURATION CONSTANT COS
DATE DATE_AND_TIME DELETE DINT DIV DO DT DWORD ELSE ELSIF END_CASE END_CONFIGURATION END_FOR END_FUNCTION END_FUNCTION_BLOCK
END_IF END_PROGRAM END_REPEAT END_RESOURCE END_STRUCT END_TYPE END_VAR END_WHILE EQ EXIT EXP EXPT EN ENO FALSE FIND FOR FUNCTION
FUNCTION_BLOCK F_EDGE GE GT IF INSERT INT INTERVAL LD LE LEFT LEN LIMIT LINT LN LOG LREAL LT LWORD MAX MID MIN MOD MOVE MUL MUX
NE NON_RETAIN NOT OF ON OR PRIORITY PROGRAM READ_ONLY READ_WRITE REAL REPEAT REPLACE RESOURCE RETAIN RETURN RIGHT ROL ROR R_EDGE
SEL SHL SHR SIN SINGLE SINT SQRT STRING STRUCT SUB TAN TASK THEN TIME TIME_OF_DAY TO TOD TRUE TRUNC TYPE UDINT UINT ULINT UNTIL
USINT VAR VAR_ACCESS VAR_EXTERNAL VAR_GLOBAL VAR_INPUT VAR_IN_OUT VAR_OUTPUT WHILE WITH WORD WSTRING XOR TON TOF TP SR RS CTU
CTD CTUD R_TRIG F_TRIG S R THIS SUPER POINTER REF_TO ADR SIZEOF CLASS METHOD INTERFACE EXTENDS IMPLEMENTS NULL STEP ACTION
""".split()) - {"S", "R"}
RANGES = {"BYTE": (0, 255), "UINT": (0, 65535), "UDINT": (0, 2**32 - 1), "DINT": (-2**31, 2**31 - 1)}
CONVERSIONS = {"BYTE_TO_DINT": ("BYTE", "DINT"), "DINT_TO_BYTE": ("DINT", "BYTE"), "DINT_TO_REAL": ("DINT", "REAL"),
               "TRUNC": ("REAL", "DINT")}
TOKEN = re.compile(r"""
    (?P<blank>\s+)|(?P<comment>\(\*)|
    (?P<typed>(?:BYTE|UINT|UDINT|DINT)\#(?:16\#[0-9A-F]+|-?[0-9]+))|
    (?P<real>[0-9]+\.[0-9]+(?:E[-+]?[0-9]+)?)|(?P<hex>16\#[0-9A-F]+)|(?P<int>[0-9]+)|
    (?P<name>[A-Za-z_][A-Za-z0-9_]*)|(?P<sign>:=|<>|<=|>=|\.\.|[-+*/()\[\];:,.<>=])""", re.VERBOSE)


class Fault(Exception):
    """The text, or what is done with it, is not what a strict compiler takes."""


class Leave(Exception):
    """RETURN."""


def real(value):
    try:
        return struct.unpack("<f", struct.pack("<f", value))[0]
    except OverflowError:
        return float("inf") if value > 0 else float("-inf")


def tokens_of(text):
    tokens, at = [], 0
    if not text.isascii():
        raise Fault("not ASCII")
    while at < len(text):
        found = TOKEN.match(text, at)
        if found is None:
            raise Fault(f"not a token: {text[at:at + 30]!r}")
        at = found.end()
        if found.lastgroup == "comment":
            end = text.find("*)", at)
            if end < 0 or "(*" in text[at:end]:
                raise Fault(f"comment in a comment, or without an end: {text[at:at + 60]!r}")
            at = end + 2
        elif found.lastgroup != "blank":
            tokens.append((found.lastgroup, found.group()))
    return tokens + [("end", "")]


class Function:
    def __init__(self, name, result):
        self.name, self.result = name, result
        self.inputs, self.in_outs, self.locals, self.body = {}, {}, {}, []


class Program:
    def __init__(self, text):
        self.tokens, self.at = tokens_of(text), 0
        self.types, self.constants, self.functions = {}, {}, {}
        self.global_names = set()
        while self.peek() != "":
            self.declaration()

    # Reading ---------------------------------------------------------------------------------------------------

    def peek(self):
        return self.tokens[self.at][1]

    def take(self, expected=None):
        kind, text = self.tokens[self.at]
        if expected is not None and text != expected:
            around = " ".join(token for _, token in self.tokens[max(0, self.at - 8):self.at + 4])
            raise Fault(f"{expected!r} is expected, there is {text!r} in: {around}")
        self.at += 1
        return kind, text

    def taken(self, text):
        if self.peek() == text:
            self.at += 1
            return True
        return False

    def name(self, scope=None):
        kind, text = self.take()
        if kind != "name" or text.upper() in WORDS or len(text) > 64 or "__" in text or text[0] == "_" or text[-1] == "_":
            raise Fault(f"{text!r} is no name")
        if scope is not None:
            if text.upper() in scope:
                raise Fault(f"{text!r} stands twice")
            scope.add(text.upper())
        return text

    def type_name(self):
        _, text = self.take()
        if text not in RANGES and text not in ("BOOL", "REAL") and text not in self.types:
            raise Fault(f"{text!r} is no type")
        return text

    def declaration(self):
        _, text = self.take()
        if text == "TYPE":
            self.type_declaration()
        elif text == "FUNCTION":
            self.function()
        elif text == "VAR_GLOBAL":
            self.take("CONSTANT")
            while not self.taken("END_VAR"):
                name = self.name(self.global_names)
                self.take(":")
                kind = self.type_name()
                self.take(":=")
                self.constants[name] = self.converted(self.literal(), kind)
                self.take(";")
        else:
            raise Fault(f"{text!r} begins no declaration")

    def type_declaration(self):
        name = self.name(self.global_names)
        self.take(":")
        if self.taken("ARRAY"):
            for expected in ("[", "0", ".."):
                self.take(expected)
            length = int(self.take()[1]) + 1
            self.take("]")
            self.take("OF")
            self.types[name] = ("array", length, self.type_name())
        else:
            self.take("STRUCT")
            members, scope = {}, set()
            while not self.taken("END_STRUCT"):
                member = self.name(scope)
                self.take(":")
                members[member] = self.type_name()
                self.take(";")
            if not members:
                raise Fault(f"{name} is empty")
            self.types[name] = ("struct", members)
        self.take(";")
        self.take("END_TYPE")

    def function(self):
        function = Function(self.name(self.global_names), None)
        self.take(":")
        function.result = self.type_name()
        scope = {function.name.upper()}
        for section, variables in (("VAR_INPUT", function.inputs), ("VAR_IN_OUT", function.in_outs),
                                   ("VAR", function.locals)):
            while self.taken(section):
                while not self.taken("END_VAR"):
                    name = self.name(scope)
                    self.take(":")
                    variables[name] = self.type_name()
                    self.take(";")
        function.body = self.statements({"END_FUNCTION"})
        self.take("END_FUNCTION")
        self.functions[function.name] = function

    def statements(self, ends):
        result = []
        while self.peek() not in ends:
            if self.taken("RETURN"):
                result.append(("return",))
            elif self.taken("IF"):
                result.append(self.choice())
            else:
                target = self.variable()
                self.take(":=")
                result.append(("assign", target, self.expression()))
            self.take(";")
        return result

    def choice(self):
        branches = []
        while True:
            condition = self.expression()
            self.take("THEN")
            branches.append((condition, self.statements({"ELSIF", "ELSE", "END_IF"})))
            if not self.taken("ELSIF"):
                break
        otherwise = self.statements({"END_IF"}) if self.taken("ELSE") else []
        self.take("END_IF")
        return ("if", branches, otherwise)

    def variable(self):
        node = ("name", self.name())
        while self.peek() in (".", "["):
            if self.taken("."):
                node = ("member", node, self.name())
            else:
                self.take("[")
                node = ("element", node, int(self.take()[1]))
                self.take("]")
        return node

    LEVELS = (("OR",), ("AND",), ("=", "<>"), ("<", ">", "<=", ">="), ("+", "-"), ("*", "/", "MOD"))

    def expression(self, level=0):
        if level == len(self.LEVELS):
            return self.factor()
        left = self.expression(level + 1)
        while self.peek() in self.LEVELS[level]:
            left = ("binary", self.take()[1], left, self.expression(level + 1))
        return left

    def factor(self):
        kind, text = self.tokens[self.at]
        if self.taken("("):
            inner = self.expression()
            self.take(")")
            return inner
        if self.taken("NOT"):
            return ("not", self.factor())
        if text in ("TRUE", "FALSE") or kind in ("typed", "real", "hex", "int") or text == "-":
            return ("literal", self.literal())
        if kind == "name" and self.tokens[self.at + 1][1] == "(":
            return self.call_expression()
        return self.variable()

    def call_expression(self):
        name = self.take()[1]
        self.take("(")
        arguments = []
        while not self.taken(")"):
            formal = None
            if self.tokens[self.at + 1][1] == ":=":
                formal = self.name()
                self.take(":=")
            arguments.append((formal, self.expression()))
            if self.peek() != ")":
                self.take(",")
        return ("call", name, arguments)

    def literal(self):
        negative = self.taken("-")
        kind, text = self.take()
        sign = -1 if negative else 1
        if kind == "typed" and not negative:
            type_name, _, digits = text.partition("#")
            value = int(digits[3:], 16) if digits.startswith("16#") else int(digits)
            return self.converted((None, value), type_name)
        if kind == "real":
            return ("REAL", real(sign * float(text)))
        if kind in ("int", "hex"):
            return (None, sign * (int(text[3:], 16) if kind == "hex" else int(text)))
        if text in ("TRUE", "FALSE") and not negative:
            return ("BOOL", text == "TRUE")
        raise Fault(f"{text!r} is no literal")

    def converted(self, value, kind):
        if value[0] is None and kind in RANGES and RANGES[kind][0] <= value[1] <= RANGES[kind][1]:
            return (kind, value[1])
        if value[0] != kind:
            raise Fault(f"{value} is no {kind}")
        return value

    # Running ---------------------------------------------------------------------------------------------------

    def new(self, kind):
        if kind in self.types:
            shape = self.types[kind]
            if shape[0] == "array":
                return [self.new(shape[2]) for _ in range(shape[1])]
            return {name: self.new(member) for name, member in shape[1].items()}
        return {"BOOL": False, "REAL": 0.0}.get(kind, 0)

    def call(self, name, **arguments):
        """Runs a function; arrays and structures of VAR_IN_OUT are changed in place."""
        function = self.functions[name]
        if set(arguments) != set(function.inputs) | set(function.in_outs):
            raise Fault(f"{name} is called with {sorted(arguments)}")
        frame = {"": function}
        frame.update({variable: self.new(kind) for variable, kind in function.locals.items()})
        frame.update(arguments)
        frame[name] = self.new(function.result)
        try:
            self.run(function.body, frame)
        except Leave:
            pass
        return frame

    def kind_of_name(self, name, frame):
        function = frame[""]
        for variables in (function.inputs, function.in_outs, function.locals):
            if name in variables:
                return variables[name]
        if name == function.name:
            return function.result
        raise Fault(f"{name} is not declared in {function.name}")

    def place(self, node, frame):
        """(container, key, type)"""
        if node[0] == "name":
            return frame, node[1], self.kind_of_name(node[1], frame)
        container, key, kind = self.place(node[1], frame)
        shape = self.types.get(kind)
        if shape is None:
            raise Fault(f"{kind} has no parts")
        if node[0] == "member" and shape[0] == "struct" and node[2] in shape[1]:
            return container[key], node[2], shape[1][node[2]]
        if node[0] == "element" and shape[0] == "array" and 0 <= node[2] < shape[1]:
            return container[key], node[2], shape[2]
        raise Fault(f"{node} is no part of {kind}")

    def run(self, statements, frame):
        for statement in statements:
            if statement[0] == "return":
                raise Leave()
            if statement[0] == "assign":
                container, key, kind = self.place(statement[1], frame)
                if statement[1][0] == "name" and key in frame[""].inputs:
                    raise Fault(f"{key} is an input")
                container[key] = self.converted(self.value(statement[2], frame), kind)[1]
                continue
            for condition, body in statement[1]:
                if self.converted(self.value(condition, frame), "BOOL")[1]:
                    self.run(body, frame)
                    break
            else:
                self.run(statement[2], frame)

    def value(self, node, frame):
        if node[0] == "literal":
            return node[1]
        if node[0] == "not":
            return ("BOOL", not self.converted(self.value(node[1], frame), "BOOL")[1])
        if node[0] == "binary":
            return self.binary(node[1], self.value(node[2], frame), self.value(node[3], frame))
        if node[0] == "call":
            return self.called(node[1], node[2], frame)
        container, key, kind = self.place(node, frame)
        return (kind, container[key])

    def binary(self, sign, left, right):
        kind = left[0] or right[0]
        left, right = self.converted(left, kind)[1], self.converted(right, kind)[1]
        if sign in ("=", "<>", "<", ">", "<=", ">="):
            return ("BOOL", {"=": left == right, "<>": left != right, "<": left < right, ">": left > right,
                             "<=": left <= right, ">=": left >= right}[sign])
        if sign in ("AND", "OR"):
            if kind not in ("BOOL", "BYTE"):
                raise Fault(f"{sign} of {kind}")
            return (kind, left & right if sign == "AND" else left | right)
        if kind == "REAL":
            return (kind, real({"+": lambda: left + right, "-": lambda: left - right, "*": lambda: left * right,
                                "/": lambda: left / right}[sign]()))
        if kind != "DINT":
            raise Fault(f"{sign} of {kind}")
        quotient = abs(left) // abs(right) * (1 if (left < 0) == (right < 0) else -1) if sign in ("/", "MOD") else 0
        result = {"+": left + right, "-": left - right, "*": left * right, "/": quotient,
                  "MOD": left - quotient * right}[sign]
        return self.converted((None, result), kind)

    def called(self, name, arguments, frame):
        if name in CONVERSIONS or name in ("ABS", "LIMIT"):
            values = [self.value(argument, frame) for formal, argument in arguments if formal is None]
            if len(values) != len(arguments):
                raise Fault(f"{name} has no such inputs")
            return self.standard(name, values)
        if name not in self.functions:
            raise Fault(f"{name} is no function that stands before")
        function = self.functions[name]
        given, back = {}, []
        for formal, argument in arguments:
            if formal in function.in_outs:
                container, key, kind = self.place(argument, frame)
                if kind != function.in_outs[formal]:
                    raise Fault(f"{formal} of {name} is no {kind}")
                given[formal] = container[key]
                back.append((formal, container, key))
            elif formal in function.inputs:
                given[formal] = self.converted(self.value(argument, frame), function.inputs[formal])[1]
            else:
                raise Fault(f"{name} has no {formal}")
        inner = self.call(name, **given)
        for formal, container, key in back:
            container[key] = inner[formal]
        return (function.result, inner[name])

    def standard(self, name, values):
        if name == "ABS" and len(values) == 1 and values[0][0] == "REAL":
            return ("REAL", abs(values[0][1]))
        if name == "LIMIT" and len(values) == 3 and all(value[0] == "REAL" for value in values):
            return ("REAL", min(max(values[1][1], values[0][1]), values[2][1]))
        if name not in CONVERSIONS or len(values) != 1:
            raise Fault(f"{name} of {values}")
        source, target = CONVERSIONS[name]
        value = self.converted(values[0], source)[1]
        if target == "REAL":
            return ("REAL", real(value))
        return self.converted((None, int(value)), target)
