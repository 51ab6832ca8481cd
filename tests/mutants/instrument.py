"""One instrumented copy of a source file instead of one copy a mutant: each point that can be mutated becomes an expression that asks at run time
which of its variants is wanted.  The points come from clang's syntax tree, whose nodes carry exact offsets into the file.

Variants are computed beside the original from operands that are evaluated once, so that a run that only watches (see mutants.c) learns for every
mutant in which cases it makes a difference at all."""
import json
import os
import re
import subprocess

CLANG = ['clang', '-std=c99', '-fsyntax-only', '-w', '-Xclang', '-ast-dump=json', '-D_POSIX_C_SOURCE=200809L']
# Macros of the C library that evaluate their argument become functions, so that the argument is an expression like any other.
PRELUDE = '#include <math.h>\n' + ''.join(
    '#undef %s\nint %s(double x);\n' % (f, f) for f in ('isfinite', 'isnan', 'isinf', 'signbit'))

RELATIONS = {'<': ['<=', '>='], '<=': ['<', '>'], '>': ['>=', '<='], '>=': ['>', '<'], '==': ['!=', '<=', '>='], '!=': ['==', '<', '>']}
NEGATED = {'==': '!=', '!=': '==', '<': '>=', '>=': '<', '>': '<=', '<=': '>'}
BOUNDARY = {'<': '<=', '<=': '<', '>': '>=', '>=': '>'}
ARITHMETIC = {'+': ['-'], '-': ['+'], '*': ['/'], '/': ['*'], '%': ['*'], '&': ['|'], '|': ['&'], '^': ['&'], '<<': ['>>'], '>>': ['<<']}
# a op b is b op a to the last bit.
COMMUTE = re.compile(r'^(fmin|fmax|hypot|fmp[qz]_(add|mul|equal|add_si)|ar[bf]_(add|mul|equal|union|add_arf|mul_arf)|mp[zq]_(add|mul)|et_size_mul|et_size_array|et_vec3_distance|et_dd_(add|mul|two_sum)|memcmp|strcmp|lesser|greater|'
                     r'fmpz_(gcd|lcm|mul2_uiui))$')
UNWRAP = {'sqrt', 'fabs'}
INTEGERS = re.compile(r'^(unsigned |signed )?(char|short|int|long|long long|__int128)$|^unsigned$|^_Bool$|^(unsigned|signed) (long|short) int$')


def qual(node):
    t = node.get('type', {})
    return re.sub(r'\b(const|volatile|restrict) ?', '', t.get('desugaredQualType', t.get('qualType', ''))).strip()


def kind_of(node):
    t = qual(node)
    if t in ('double', 'float'):
        return 'real'
    if t.endswith('*') or '[' in t or '(*)' in t:
        return 'pointer'
    if INTEGERS.match(t):
        return 'unsigned' if 'unsigned' in t or t == '_Bool' else 'signed'
    return 'enum' if t.startswith('enum ') else 'other'


def bare(node):
    while node.get('kind') in ('ImplicitCastExpr', 'ParenExpr', 'ConstantExpr'):
        node = node['inner'][0]
    return node


class Unit:
    """One file: its text and its points."""

    def __init__(self, path, text):
        self.path, self.text = path, text
        self.name = re.sub(r'\W', '_', path)
        self.points = []         # number of variants of each
        self.mutants = []        # dicts, in order
        self.pieces = []         # (start, end, new text) of functions
        self.function = None

    # Offsets.  A macro counts as one token; one with arguments reaches to its closing parenthesis.
    def place(self, where, end):
        macro = 'expansionLoc' in where
        loc = where['expansionLoc'] if macro else where
        if 'offset' not in loc or loc.get('at') != self.path:
            return None
        at = loc['offset']
        if not end:
            return at
        at += loc['tokLen']
        if macro:
            after = re.compile(r'\s*\(').match(self.text, at)
            if after and self.text[loc['offset']:at] not in self.ownmacros:
                depth, at = 1, after.end()
                while depth:
                    depth += {'(': 1, ')': -1}.get(self.text[at], 0)
                    at += 1
        return at

    def span(self, node):
        r = node.get('range', {})
        if not r.get('begin') or not r.get('end'):
            return None
        a, b = self.place(r['begin'], False), self.place(r['end'], True)
        return None if a is None or b is None or b <= a else (a, b)

    def in_macro(self, node):
        b, e = node['range']['begin'], node['range']['end']
        return 'expansionLoc' in b and 'expansionLoc' in e and b['expansionLoc']['offset'] == e['expansionLoc']['offset']

    def source(self, node):
        a, b = self.span(node)
        return self.text[a:b]

    def short(self, text):
        text = re.sub(r'/\*.*?\*/', '', text, flags=re.S)
        return re.sub(r'\s+', ' ', text).strip()

    def point(self, node, operator, variants):
        """A point with these (before, after) variants; its number, or None when there are none."""
        p = len(self.points)
        self.points.append(len(variants))
        a, _ = self.span(node)
        begin = self.text.rfind('\n', 0, a) + 1
        for i, (before, after) in enumerate(variants):
            self.mutants.append(dict(file=self.path, function=self.function, line=self.text.count('\n', 0, a) + 1, column=a - begin + 1, point=p, variant=i + 1,
                                     operator=operator, before=self.short(before), after=self.short(after)))
        return p

    def on(self, p):
        return '__builtin_expect(et_on_%s[%d], 0)' % (self.name, p)

    def choose(self, p, value, entries):
        """value is a variable's name; entries[0] is the original."""
        return 'if (%s) { __typeof__(%s) m%d[] = { %s }; %s = m%d[et_choose(&et_at_%s, %d, m%d, sizeof m%d[0], %d)]; }' % (
            self.on(p), value, p, ', '.join(entries), value, p, self.name, p, p, p, len(entries))

    def flip(self, p):
        return '(%s ? et_flip(&et_at_%s, %d) : 0)' % (self.on(p), self.name, p)

    # Statements.
    def statement(self, node, tail):
        """The statement's text without the final semicolon where clang's range is without it."""
        kind = node['kind']
        if kind == 'CompoundStmt':
            inner = node.get('inner', [])
            return self.generic(node, lambda c: self.statement(c, tail and c is inner[-1]))
        if kind == 'IfStmt':
            parts = node['inner']
            return self.generic(node, lambda c: self.condition(c) if c is parts[0] else self.statement(c, tail))
        if kind in ('WhileStmt', 'SwitchStmt'):
            first = node['inner'][0]
            cond = self.condition if kind == 'WhileStmt' else self.expression
            return self.generic(node, lambda c: cond(c) if c is first else self.statement(c, False))
        if kind == 'DoStmt':
            last = node['inner'][-1]
            return self.generic(node, lambda c: self.condition(c) if c is last else self.statement(c, False))
        if kind == 'ForStmt':
            init, _, cond, step, body = node['inner']
            return self.generic(node, lambda c: self.condition(c) if c is cond else self.statement(c, False) if c is body
                                else self.declaration(c) if c.get('kind') == 'DeclStmt' else self.expression(c, unused=True))
        if kind in ('CaseStmt', 'DefaultStmt'):
            last = node['inner'][-1]
            return self.generic(node, lambda c: self.statement(c, False) if c is last else self.source(c))
        if kind == 'LabelStmt':
            return self.generic(node, lambda c: self.statement(c, tail))
        if kind == 'DeclStmt':
            return self.declaration(node)
        if kind == 'ReturnStmt':
            core = bare(node['inner'][0]) if node.get('inner') else {}
            if self.says_truth and core.get('value') == '1':
                core['truth'] = True
            text = self.generic(node, self.expression)
            if tail and node.get('inner'):
                return text
            return self.droppable(node, text)
        if kind in ('BreakStmt', 'ContinueStmt'):
            return self.droppable(node, self.source(node))
        if kind in ('NullStmt', 'GotoStmt'):
            return self.source(node)
        if self.in_macro(node):
            return self.droppable(node, self.source(node))
        core = bare(node)
        if core['kind'] == 'CStyleCastExpr' and qual(core) == 'void':
            return self.source(node)
        p = len(self.points)
        self.point(node, 'statement', [(self.source(node) + ';', ';')])
        return self.drop(p, self.expression(node, unused=True))

    def drop(self, p, text):
        return 'if (%s && et_flip(&et_at_%s, %d)) ; else %s' % (self.on(p), self.name, p, text)

    def droppable(self, node, text):
        return self.drop(self.point(node, 'statement', [(self.source(node) + ';', ';')]), text)

    def declaration(self, node):
        def variable(c):
            if c['kind'] != 'VarDecl' or c.get('storageClass') == 'static':
                return self.source(c)
            return self.generic(c, self.initializer)
        return self.generic(node, variable)

    def initializer(self, node):
        if node['kind'] == 'InitListExpr':
            return self.generic(node, self.initializer)
        return self.expression(node)

    # Expressions.
    def generic(self, node, render):
        """The node's own text, its children rendered."""
        a, b = self.span(node)
        out, at = [], a
        todo = []
        for c in node.get('inner', []):
            s = self.span(c) if c else None
            if s and a <= s[0] and s[1] <= b:
                todo.append((s, c))
        todo.sort(key=lambda t: t[0])
        for (s, e), c in todo:
            if s < at:
                if c['kind'] == 'VarDecl':      # `int a = 1, b = 2`: each range begins with the type
                    s = at
                    out.append(self.declarator(c, at, e))
                    at = e
                continue
            out.append(self.text[at:s])
            out.append(render(c))
            at = e
        out.append(self.text[at:b])
        return ''.join(out)

    def declarator(self, node, a, b):
        init = [c for c in node.get('inner', []) if c and self.span(c) and self.span(c)[0] >= a and c['kind'] not in ('FullComment',)]
        if not init or node.get('storageClass') == 'static':
            return self.text[a:b]
        s, e = self.span(init[-1])
        return self.text[a:s] + self.initializer(init[-1]) + self.text[e:b]

    def condition(self, node):
        core = bare(node)
        if core['kind'] == 'BinaryOperator' and core['opcode'] in RELATIONS or core['kind'] == 'UnaryOperator' and core['opcode'] == '!' \
                or core['kind'] == 'IntegerLiteral' or self.in_macro(core):
            return self.expression(node)
        text = self.source(node)
        p = self.point(node, 'negated', [(text, '!(%s)' % text)])
        return '({ int o%d = !!(%s); o%d ^ %s; })' % (p, self.expression(node), p, self.flip(p))

    def expression(self, node, unused=False):
        kind = node['kind']
        if self.in_macro(node):
            return self.macro(node)
        if kind in ('ImplicitCastExpr', 'ConstantExpr'):
            if node.get('castKind') in ('NullToPointer', 'FunctionToPointerDecay') or kind == 'ConstantExpr':
                return self.source(node)
            return self.expression(node['inner'][0], unused)
        if kind == 'ParenExpr':
            return '(' + self.expression(node['inner'][0]) + ')'
        handler = getattr(self, 'do_' + kind, None)
        return handler(node, unused) if handler else self.generic(node, self.expression)

    def macro(self, node):
        text, core = self.source(node), bare(node)
        if text in self.ownmacros and kind_of(core) in ('real', 'unsigned', 'signed') and core['kind'] in ('FloatingLiteral', 'IntegerLiteral'):
            return self.constant(node, text, core)
        return text

    ownmacros = ()

    def constant(self, node, text, core):
        if core['kind'] == 'FloatingLiteral':
            v = float(core['value'])
            after = ['1.0'] if v == 0 else ['0.0', '2.0'] if v == 1 else ['2 * ' + text, text + ' / 2']
            made = ['2 * %s' % text, '%s / 2' % text] if v not in (0, 1) else after
        else:
            v = int(core['value'])
            after = [str(v + 1)] if v == 0 else [str(v + 1), str(v - 1)]
            if core.get('truth'):
                after = ['0']
            if text in self.ownmacros:
                after = [text + ' + 1', text + ' - 1']
            made = ['0'] if core.get('truth') else ['%s + 1' % text] if v == 0 else ['%s + 1' % text, '%s - 1' % text]
        p = self.point(node, 'constant', [(text, x) for x in after])
        return '({ __auto_type o%d = %s; %s o%d; })' % (p, text, self.choose(p, 'o%d' % p, ['o%d' % p] + made), p)

    def do_IntegerLiteral(self, node, unused):
        return self.constant(node, self.source(node), node)

    do_FloatingLiteral = do_IntegerLiteral

    def do_UnaryExprOrTypeTraitExpr(self, node, unused):
        return self.source(node)

    do_OffsetOfExpr = do_StringLiteral = do_UnaryExprOrTypeTraitExpr

    def do_InitListExpr(self, node, unused):
        return self.generic(node, self.initializer)

    def do_DeclRefExpr(self, node, unused):
        d = node.get('referencedDecl', {})
        text = self.source(node)
        if d.get('kind') == 'EnumConstantDecl' and d['name'] in self.enums:
            v, size = self.enums[d['name']]
            after = [text + ' + 1', text + ' - 1'] if size else ['1' if v == 0 else '0']
            p = self.point(node, 'constant', [(text, x) for x in after])
            return '({ __auto_type o%d = %s; %s o%d; })' % (p, text, self.choose(p, 'o%d' % p, ['o%d' % p] + after), p)
        return text

    enums = {}

    def do_ConditionalOperator(self, node, unused):
        cond, yes, no = node['inner']
        core = bare(cond)
        least = None
        if core['kind'] == 'BinaryOperator' and core['opcode'] in BOUNDARY:
            arms = {self.short(self.source(bare(c))) for c in (yes, no)}
            if arms == {self.short(self.source(bare(c))) for c in core['inner']}:
                least = core
            if kind_of(yes) != 'real' and self.differences(core, bare(yes), bare(no)):
                least = core
        core['minmax'] = least is not None
        return self.generic(node, lambda c: self.condition(c) if c is cond else self.expression(c))

    def differences(self, cond, yes, no):
        """a < b ? b - a : a - b, which is 0 either way where a is b."""
        if any(c['kind'] != 'BinaryOperator' or c['opcode'] != '-' for c in (yes, no)):
            return False
        a, b = (self.short(self.source(bare(c))) for c in cond['inner'])
        pairs = {tuple(self.short(self.source(bare(x))) for x in c['inner']) for c in (yes, no)}
        return pairs == {(a, b), (b, a)}

    def do_BinaryOperator(self, node, unused):
        op, (left, right) = node['opcode'], node['inner']
        if op in ('&&', '||'):
            other = '||' if op == '&&' else '&&'
            a, b = self.source(left), self.source(right)
            p = self.point(node, 'logical', [('%s %s %s' % (a, op, b), '%s %s %s' % (a, other, b))])
            return '({ int l%d = !!(%s); l%d == (%d ^ %s) ? l%d : !!(%s); })' % (
                p, self.clause(left), p, 0 if op == '&&' else 1, self.flip(p), p, self.clause(right))
        if op in RELATIONS or op in ARITHMETIC:
            return self.binary(node, op, left, right)
        return self.generic(node, self.expression)

    def clause(self, node):
        return self.condition(node) if bare(node)['kind'] in ('CallExpr', 'DeclRefExpr', 'MemberExpr', 'ArraySubscriptExpr') else self.expression(node)

    def variants(self, node, op, left, right):
        l, r = kind_of(left), kind_of(right)
        if op in ARITHMETIC:
            if 'pointer' in (l, r):
                return [] if l == r else ARITHMETIC[op]
            return ['+'] if op == '*' and l != 'real' and r != 'real' else ARITHMETIC[op]
        inner = [bare(left), bare(right)]
        kinds = [kind_of(n) for n in inner]
        if 'pointer' in (l, r) or 'enum' in kinds or 'other' in kinds or any(
                n['kind'] == 'DeclRefExpr' and n.get('referencedDecl', {}).get('kind') == 'EnumConstantDecl' and n['referencedDecl']['name'].startswith('ET_') for n in inner):
            return [NEGATED[op]]
        wanted = RELATIONS[op]
        if 'unsigned' in (l, r):        # counts and indices are compared for equality where they can only be on one side
            wanted = wanted[:1] if op in ('==', '!=') else wanted
        if node.get('minmax') and 'real' not in (l, r):
            wanted = [x for x in wanted if x != BOUNDARY[op]]
        return wanted

    def binary(self, node, op, left, right):
        wanted = self.variants(node, op, left, right)
        a, b = self.source(left), self.source(right)
        if not wanted:
            return self.generic(node, self.expression)
        p = self.point(node, 'relational' if op in RELATIONS else 'arithmetic', [('%s %s %s' % (a, op, b), '%s %s %s' % (a, w, b)) for w in wanted])
        l, r, o = 'l%d' % p, 'r%d' % p, 'o%d' % p
        entries = [o]
        for i, w in enumerate(wanted):
            e = '%s %s %s' % (l, w, r)
            if w in ('/', '%') and 'real' not in (kind_of(left), kind_of(right)):
                e = '(%s ? %s : (et_trap(&et_at_%s, %d, %d), %s))' % (r, e, self.name, p, i + 1, o)
            if node.get('minmax') and w == BOUNDARY.get(op):
                e = '(%s == %s && et_same(&%s, &%s, sizeof %s) ? %s : (%s))' % (l, r, l, r, l, o, e)
            entries.append(e)
        return '({ __auto_type %s = (%s); __auto_type %s = (%s); __auto_type %s = %s %s %s; %s %s; })' % (
            l, self.expression(left), r, self.expression(right), o, l, op, r, self.choose(p, o, entries), o)

    def do_UnaryOperator(self, node, unused):
        op, inner = node['opcode'], node['inner'][0]
        if op in ('++', '--'):
            return self.step(node, op, inner)
        if op in ('-', '!') and bare(inner)['kind'] not in ('IntegerLiteral', 'FloatingLiteral'):
            text = self.source(inner)
            p = self.point(node, 'negated' if op == '!' else 'arithmetic', [(op + text, text)])
            return '({ __auto_type x%d = (%s); __auto_type o%d = %sx%d; %s o%d; })' % (
                p, self.expression(inner), p, op, p, self.choose(p, 'o%d' % p, ['o%d' % p, ('!!' if op == '!' else '') + 'x%d' % p]), p)
        return self.generic(node, self.expression)

    def target(self, p, lvalue):
        """Declaration and name of what is assigned to."""
        if bare(lvalue)['kind'] == 'DeclRefExpr':
            return '', self.source(lvalue)
        return '__auto_type p%d = &(%s); ' % (p, self.expression(lvalue)), '(*p%d)' % p

    def step(self, node, op, inner):
        text, other = self.source(inner), '--' if op == '++' else '++'
        before, after = (text + op, text + other) if node.get('isPostfix') else (op + text, other + text)
        p = self.point(node, 'increment', [(before, after)])
        declare, x = self.target(p, inner)
        sign = op[0], other[0]
        entries = ['w%d %s 1' % (p, s) for s in sign]
        return '({ %s__auto_type w%d = %s; __auto_type o%d = %s; %s %s = o%d; %s; })' % (
            declare, p, x, p, entries[0], self.choose(p, 'o%d' % p, entries), x, p, 'w%d' % p if node.get('isPostfix') else x)

    def do_CompoundAssignOperator(self, node, unused):
        op = node['opcode'][:-1]
        left, right = node['inner']
        wanted = ARITHMETIC[op]
        if op == '*' and kind_of(left) != 'real':
            wanted = ['+']
        a, b = self.source(left), self.source(right)
        p = self.point(node, 'arithmetic', [('%s %s= %s' % (a, op, b), '%s %s= %s' % (a, w, b)) for w in wanted])
        declare, x = self.target(p, left)
        r = 'r%d' % p
        entries = ['%s %s %s' % (x, op, r)]
        for i, w in enumerate(wanted):
            e = '%s %s %s' % (x, w, r)
            if w in ('/', '%') and kind_of(left) != 'real':
                e = '(%s ? %s : (et_trap(&et_at_%s, %d, %d), %s))' % (r, e, self.name, p, i + 1, x)
            entries.append(e)
        return '({ %s__auto_type %s = (%s); __typeof__(%s) o%d; if (%s) { __typeof__(%s) m%d[] = { %s }; o%d = m%d[et_choose(&et_at_%s, %d, m%d, ' \
            'sizeof m%d[0], %d)]; } else o%d = %s; %s = o%d; })' % (
                declare, r, self.expression(right), x + (' + 0' if kind_of(left) != 'pointer' and False else ''), p, self.on(p), x, p, ', '.join(entries), p, p,
                self.name, p, p, p, len(entries), p, entries[0], x, p)

    def do_ArraySubscriptExpr(self, node, unused):
        base, index = node['inner']
        core = bare(index)
        plus = core['kind'] == 'BinaryOperator' and core['opcode'] in '+-' and any(bare(c)['kind'] == 'IntegerLiteral' for c in core['inner'])
        if core['kind'] == 'IntegerLiteral' or plus or self.in_macro(index) or self.span(base)[0] > self.span(index)[0]:
            return self.generic(node, self.expression)
        text, of = self.source(index), self.source(base)
        p = self.point(node, 'index', [('%s[%s]' % (of, text), '%s[%s %s 1]' % (of, text, s)) for s in '+-'])
        i = 'o%d' % p
        new = '({ __auto_type %s = (%s) + 0; %s %s; })' % (i, self.expression(index), self.choose(p, i, [i, i + ' + 1', i + ' - 1']), i)
        return self.generic(node, lambda c: new if c is index else self.expression(c))

    def do_CallExpr(self, node, unused):
        callee, args = node['inner'][0], node['inner'][1:]
        name = bare(callee).get('referencedDecl', {}).get('name', '')
        if name in UNWRAP and len(args) == 1:
            text = self.source(args[0])
            p = self.point(node, 'call', [('%s(%s)' % (name, text), text)])
            return '({ __auto_type x%d = (%s); __auto_type o%d = %s(x%d); %s o%d; })' % (
                p, self.expression(args[0]), p, name, p, self.choose(p, 'o%d' % p, ['o%d' % p, 'x%d' % p]), p)
        pairs = [i for i in range(len(args) - 1) if self.alike(args[i], args[i + 1], name)]
        if COMMUTE.match(name):
            first = {2: 0, 3: 1, 4: 1}.get(len(args), 0)
            pairs = [i for i in pairs if i != first]
        if not pairs:
            return self.generic(node, self.expression)
        texts = [self.source(a) for a in args]
        swapped = []
        for i in pairs:
            t = list(texts)
            t[i], t[i + 1] = t[i + 1], t[i]
            swapped.append(('%s(%s)' % (name, ', '.join(texts)), '%s(%s)' % (name, ', '.join(t))))
        p = self.point(node, 'arguments', swapped)
        moved = sorted({i for i in pairs} | {i + 1 for i in pairs})
        declare = ''.join('__auto_type a%d_%d = (%s); ' % (p, i, self.expression(args[i])) for i in moved)
        declare += 'int o%d = 0; if (%s) { int m%d[] = { 0, %s }; o%d = m%d[et_choose(&et_at_%s, %d, m%d, sizeof m%d[0], %d)]; } ' % (
            p, self.on(p), p, ', '.join('et_same(&a%d_%d, &a%d_%d, sizeof a%d_%d) ? 0 : %d' % (p, i, p, i + 1, p, i, k + 1) for k, i in enumerate(pairs)),
            p, p, self.name, p, p, p, len(pairs) + 1)

        def argument(i):
            text = 'a%d_%d' % (p, i)
            for k, j in enumerate(pairs):
                if i == j:
                    text = 'o%d == %d ? a%d_%d : %s' % (p, k + 1, p, i + 1, text)
                elif i == j + 1:
                    text = 'o%d == %d ? a%d_%d : %s' % (p, k + 1, p, i - 1, text)
            return text
        where = {id(a): i for i, a in enumerate(args)}
        call = self.generic(node, lambda c: argument(where[id(c)]) if where.get(id(c)) in moved else self.expression(c))
        return '({ %s%s; })' % (declare, call)

    def alike(self, a, b, name):
        if any(self.in_macro(x) and x['kind'] != 'IntegerLiteral' and 'NULL' in self.source(x) for x in (a, b)):
            return False
        ka, kb = qual(a).replace(' ', ''), qual(b).replace(' ', '')
        ca, cb = bare(a), bare(b)
        if ca['kind'] == cb['kind'] == 'IntegerLiteral' and ca['value'] == cb['value'] or self.short(self.source(a)) == self.short(self.source(b)):
            return False
        if 'StringLiteral' in (ca['kind'], cb['kind']) or '(*)' in ka or ca.get('valueCategory') == 'function':
            return False
        return ka == kb and (kind_of(a) != 'other' or '(' not in ka)

    def only_truth(self, node):
        """Every return is 0, 1 or a comparison: 2 for 1 is the same truth."""
        if node.get('kind') == 'ReturnStmt':
            core = bare(node['inner'][0])
            return core['kind'] == 'IntegerLiteral' and core['value'] in '01' or core.get('opcode') in ('&&', '||', '!', *RELATIONS) or core['kind'] == 'CallExpr'
        return all(self.only_truth(c) for c in node.get('inner', []) if c)

    def take_function(self, node):
        body = [c for c in node.get('inner', []) if c.get('kind') == 'CompoundStmt']
        if not body or not self.span(body[0]):
            return
        self.function = node['name']
        self.says_truth = node['type']['qualType'].startswith('int (') and self.only_truth(body[0])
        a, b = self.span(body[0])
        self.pieces.append((a, b, self.statement(body[0], True)))

    def result(self):
        out, at = [], 0
        head = '#include "mutants.h"\nextern unsigned char et_on_%s[];\nextern const et_points et_at_%s;\n' % (self.name, self.name)
        for a, b, text in sorted(self.pieces):
            out.append(self.text[at:a])
            out.append(text)
            at = b
        out.append(self.text[at:])
        return head + ''.join(out)


def chunks(path, flags, prelude):
    """The declarations at top level, as text; clang's whole tree can have hundreds of megabytes."""
    run = subprocess.Popen(CLANG + flags + ['-include', prelude, path], stdout=subprocess.PIPE, text=True)
    part = None
    for line in run.stdout:
        if line.startswith('    {'):
            part = []
        if part is not None:
            part.append(line)
            if line.startswith('    }'):
                part[-1] = '    }\n'
                yield ''.join(part)
                part = None
    if run.wait():
        raise SystemExit('mutants: clang cannot read ' + path)


FILE = re.compile(r'"file": "([^"]*)"')


def note_files(node, now):
    """clang names a file only where it changes, in the order of printing."""
    if isinstance(node, list):
        for n in node:
            now = note_files(n, now)
    elif isinstance(node, dict):
        if 'offset' in node:
            now = node.get('file', now)
            node['at'] = now
        for v in node.values():
            if isinstance(v, (dict, list)):
                now = note_files(v, now)
    return now


def instrument(paths, flags, prelude, done=()):
    """The units of these C files and of the private headers beside them."""
    with open(prelude, 'w') as f:
        f.write(PRELUDE)
    units, seen = {}, set()
    for path in paths:
        now, enums = '', {}
        for text in chunks(path, flags, prelude):
            names = FILE.findall(text)
            if not any(n.startswith('src/') or n.startswith('include/') for n in [now] + names):
                now = names[-1] if names else now
                continue
            decl = json.loads(text)
            now = note_files(decl, now)
            if decl['kind'] == 'EnumDecl':
                note_enum(decl, enums)
            at = (decl.get('loc') or {}).get('at', '')
            if decl['kind'] != 'FunctionDecl' or os.path.dirname(at) != os.path.dirname(path) or not at.startswith('src/'):
                continue
            if not any(c.get('kind') == 'CompoundStmt' for c in decl.get('inner', [])) or (at, decl['name']) in seen:
                continue
            seen.add((at, decl['name']))
            if at not in units:
                with open(at, encoding='latin-1') as f:
                    units[at] = Unit(at, f.read())
                own = re.findall(r'^#define (\w+) ', units[at].text, re.M)
                for h in re.findall(r'#include "((?!etalon)[\w/]+\.h)"', units[at].text):
                    if os.path.exists('src/' + h):
                        own += re.findall(r'^#define (\w+) ', open('src/' + h).read(), re.M)
                units[at].ownmacros = set(own)
            units[at].enums = enums
            units[at].take_function(decl)
    return units


def note_enum(decl, enums):
    """Those of src: sizes in an enum without a name, kinds in one with a name.  Those of include are kinds."""
    value = -1
    anonymous = not decl.get('name')
    for c in decl.get('inner', []):
        if c['kind'] != 'EnumConstantDecl':
            continue
        value += 1
        for e in c.get('inner', []):
            if e.get('kind') == 'ConstantExpr':
                value = int(e['value'])
        enums[c['name']] = value, anonymous and (decl.get('loc') or {}).get('at', '').startswith('src/')
