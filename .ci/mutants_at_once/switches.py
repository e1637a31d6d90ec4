"""Rewrites Rust sources so that each change of them is behind a switch."""

import re

import tree_sitter
import tree_sitter_rust

OPERATORS = {
    "+": ["-", "*"], "-": ["+", "/"], "*": ["+", "/"], "/": ["*", "%"], "%": ["/", "+"],
    "==": ["!="], "!=": ["=="], "<": [">", "=="], ">": ["<", "=="], "<=": [">"], ">=": ["<"],
    "&": ["|", "^"], "|": ["&", "^"], "^": ["|", "&"], "<<": [">>"], ">>": ["<<"], "&&": ["||"], "||": ["&&"],
    "+=": ["-=", "*="], "-=": ["+=", "/="], "*=": ["+=", "/="], "/=": ["*="],
    "&=": ["|="], "|=": ["&="], "^=": ["|="],
}
VALUES = {
    "()": ["()"], "bool": ["true", "false"], "f64": ["0.0", "1.0", "-1.0"],
    **dict.fromkeys(["usize", "u64", "u32", "u8", "isize", "i64", "i32"], ["0", "1"]),
}
# What is evaluated by the compiler, or is no code.
UNTOUCHED = {
    "const_item", "static_item", "const_block", "array_type", "type_arguments", "attribute_item", "inner_attribute_item",
    "token_tree", "macro_definition", "use_declaration", "struct_item", "enum_item", "line_comment", "block_comment",
}
SWITCH = "crate::change_switch::on"
# The characters of an operand that the name of a change tells.
CLIP = 30


def returned(kind):
    """Returns values of a type, by its text."""
    if kind in VALUES:
        return VALUES[kind]
    if kind.startswith(("&", "impl", "!")):
        return []
    if kind.startswith("Option<"):
        return ["None"]
    if kind.startswith("Result<"):
        return ["Ok(())"] if kind.startswith("Result<()") else ["Ok(Default::default())"]
    return ["Default::default()"]


def has_value(body, value):
    """Returns whether a body has this value anyway: it is the same, or its type has one value."""
    body = body.strip("{} \n").split("\n")[-1].strip()
    default = value == "Default::default()" and re.fullmatch(r"(\w+::)*default\(\)|[A-Z][A-Za-z0-9]*[a-z]", body)
    return body == value or bool(default)


def clipped(text, last):
    """Returns an operand in one line, and of a long one the last or the first characters."""
    text = " ".join(text.split())
    return text if len(text) <= CLIP else f"…{text[-CLIP:]}" if last else f"{text[:CLIP]}…"


class Changes:
    """Numbers the changes that are not dropped."""

    def __init__(self, dropped):
        self.dropped, self.names = dropped, []

    def number(self, name):
        if name in self.dropped:
            return None
        self.names.append(name)
        return len(self.names) - 1


class Source:
    """A file, whose lines keep their numbers when it is rewritten."""

    def __init__(self, path, text, changes):
        self.path, self.bytes, self.changes, self.within = path, text.encode(), changes, ""

    def rewritten(self):
        root = tree_sitter.Parser(tree_sitter.Language(tree_sitter_rust.language())).parse(self.bytes).root_node
        before, after = self.bytes[: root.start_byte], self.bytes[root.end_byte :]
        return before.decode() + self.written(root) + after.decode()

    def text(self, node):
        return self.bytes[node.start_byte : node.end_byte].decode()

    def numbers(self, node, change):
        row, column = node.start_point
        return self.changes.number(f"{self.path}:{row + 1}:{column + 1}: {self.within}: {change}")

    def written(self, node):
        """Returns the text of a node with its changes."""
        if node.type in UNTOUCHED or is_test(node, self.text):
            return self.text(node)
        rewrite = {
            "function_item": self.function, "binary_expression": self.operation,
            "compound_assignment_expr": self.assignment, "unary_expression": self.sign,
        }.get(node.type, self.inside)
        return rewrite(node)

    def inside(self, node):
        if not node.children:
            return self.text(node)
        parts, at = [], node.start_byte
        for child in node.children:
            parts += [self.bytes[at : child.start_byte].decode(), self.written(child)]
            at = child.end_byte
        return "".join(parts) + self.bytes[at : node.end_byte].decode()

    def function(self, node):
        modifiers = [self.text(child) for child in node.children if child.type == "function_modifiers"]
        if any("const" in words.split() for words in modifiers):
            return self.text(node)
        body, kind = node.child_by_field_name("body"), node.child_by_field_name("return_type")
        outer, self.within, returns = self.within, self.text(node.child_by_field_name("name")), ""
        for value in returned(self.text(kind) if kind else "()") if body.named_child_count else []:
            number = None if has_value(self.text(body), value) else self.numbers(body, f"returns {value}")
            if number is not None:
                returns += f" if {SWITCH}({number}) {{ return {value}; }}"
        head = self.bytes[node.start_byte : body.start_byte].decode()
        written = head + "{" + returns + self.inside(body)[1:]
        self.within = outer
        return written

    def operands(self, node):
        left, right = node.child_by_field_name("left"), node.child_by_field_name("right")
        sign = node.child_by_field_name("operator")
        operator, sides = self.text(sign), (clipped(self.text(left), True), clipped(self.text(right), False))
        names = {other: f"{operator} becomes {other} in {f' {operator} '.join(sides)}" for other in OPERATORS.get(operator, [])}
        numbers = [(other, self.numbers(sign, name)) for other, name in names.items()]
        return left, right, operator, [pair for pair in numbers if pair[1] is not None]

    def operation(self, node):
        left, right, operator, others = self.operands(node)
        if not others:
            return self.inside(node)
        left, right = self.written(left), self.written(right)
        if operator in ("&&", "||"):
            # The left operand decides alone if it equals what the switch says, or does not.
            same = "==" if operator == "&&" else "!="
            return f"(match {left} {{ a_ => if {SWITCH}({others[0][1]}) {same} a_ {{ a_ }} else {{ {right} }} }})"
        chain = "".join(f"if {SWITCH}({number}) {{ a_ {other} b_ }} else " for other, number in others)
        return f"(match ({left}, {right}) {{ (a_, b_) => {chain}{{ a_ {operator} b_ }} }})"

    def assignment(self, node):
        left, right, operator, others = self.operands(node)
        if not others:
            return self.inside(node)
        left = self.text(left)
        chain = "".join(f"if {SWITCH}({number}) {{ {left} {other} b_ }} else " for other, number in others)
        return f"(match {self.written(right)} {{ b_ => {chain}{{ {left} {operator} b_ }} }})"

    def sign(self, node):
        sign, operand = self.text(node)[0], node.named_children[-1]
        literal = operand.type in ("float_literal", "integer_literal")
        number = None if literal or sign not in "-!" else self.numbers(node, f"{sign} is deleted in {clipped(self.text(node), False)}")
        if number is None:
            return self.inside(node)
        return f"(match {self.written(operand)} {{ a_ => if {SWITCH}({number}) {{ a_ }} else {{ {sign}a_ }} }})"


def is_test(node, text):
    """Returns whether an item is compiled for tests only."""
    before = node.prev_sibling
    while before is not None and before.type in ("attribute_item", "line_comment", "block_comment"):
        if before.type == "attribute_item" and ("cfg(test" in text(before) or "test]" in text(before)):
            return True
        before = before.prev_sibling
    return False
