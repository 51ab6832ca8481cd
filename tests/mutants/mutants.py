#!/usr/bin/env python3
"""mutants.py --build FOLDER --objects FILES... --libs FLAGS [options]: which small faults in the code do the tests notice?

Instruments the sources (instrument.py), builds one program with all mutants in it (run.c), watches which of them make a difference in which cases of
which test, tries each in those cases, and compares what survives with the list of explained survivors.  Answers are kept in FOLDER/answers.tsv; what
is there is not tried again unless the code or, for a survivor, a test has changed."""
import argparse
import collections
import fnmatch
import functools
import hashlib
import json
import os
import re
import signal
import subprocess
import sys
import threading
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import instrument  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))
ROOMS = ['spline', 'net', 'som', 'fit', 'refine', 'exact']
CFLAGS = ['-O1', '-g0', '-w', '-std=gnu99', '-ffp-contract=off', '-fno-math-errno', '-fwrapv', '-fno-strict-aliasing', '-D_POSIX_C_SOURCE=200809L']
FLAGS = ['-Iinclude', '-Isrc']


def digest(*parts):
    h = hashlib.sha256()
    for p in parts:
        h.update(p if isinstance(p, bytes) else p.encode('utf-8', 'surrogateescape'))
        h.update(b'\0')
    return h.hexdigest()[:24]


def read(path):
    with open(path, 'rb') as f:
        return f.read()


def listed(*folders, ends):
    return sorted(os.path.join(d, f) for top in folders for d, _, fs in os.walk(top) for f in fs if f.endswith(ends))


def write_if_new(path, text):
    data = text.encode('latin-1', 'replace') if isinstance(text, str) else text
    if os.path.exists(path) and read(path) == data:
        return
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path + '.new', 'wb') as f:
        f.write(data)
    os.replace(path + '.new', path)


# Instrumenting and building.

def units_of(folder, room, sources):
    """The instrumented files of a room, as plain data; kept until a source or a header changes."""
    headers = [p for p in listed('include', 'src', ends='.h')]
    key = digest(*[read(p) for p in sources + headers], read(instrument.__file__), *sources)
    kept = os.path.join(folder, 'room_%s.json' % room)
    if os.path.exists(kept):
        with open(kept) as f:
            old = json.load(f)
        if old['key'] == key:
            return old['units']
    units = instrument.instrument(sources, FLAGS, os.path.join(folder, 'prelude.h'))
    made = [dict(path=u.path, name=u.name, points=u.points, mutants=u.mutants, text=u.result(), source=digest(u.text)) for u in units.values()]
    with open(kept + '.new', 'w') as f:
        json.dump(dict(key=key, units=made), f)
    os.replace(kept + '.new', kept)
    return made


def name_mutants(units):
    """Every mutant gets its number and a name that outlives changes elsewhere in the file."""
    every = []
    for u in units:
        count = collections.Counter()
        for m in u['mutants']:
            same = (m['function'], m['before'], m['after'])
            count[same] += 1
            m['which'] = count[same]
            m['name'] = '%s\t%s\t%s\t%s\t%d' % (m['file'], m['function'], m['before'], m['after'], m['which'])
            m['source'] = u['source']
            m['number'] = len(every)
            every.append(m)
    return every


def tables(units):
    out, number = ['#include "mutants.h"'], 0
    for u in units:
        first = []
        for n in u['points']:
            first.append(number)
            number += n
        first.append(number)
        out.append('unsigned char et_on_%s[%d];' % (u['name'], max(1, len(u['points']))))
        out.append('static const unsigned first_%s[] = { %s };' % (u['name'], ', '.join(map(str, first))))
        out.append('const et_points et_at_%s = { "%s", et_on_%s, first_%s, %d };' % (u['name'], u['path'], u['name'], u['name'], len(u['points'])))
    out.append('const et_points *const et_files[] = { %s 0 };' % ''.join('&et_at_%s, ' % u['name'] for u in units))
    out.append('const unsigned et_mutants = %d;' % number)
    return '\n'.join(out) + '\n'


def compile_one(cc, source, target, flags, key):
    if os.path.exists(target) and os.path.exists(target + '.key') and read(target + '.key').decode() == key:
        return None
    os.makedirs(os.path.dirname(target), exist_ok=True)
    done = subprocess.run([cc] + flags + ['-c', '-o', target, source], stderr=subprocess.PIPE, text=True)
    if done.returncode:
        return done.stderr[:3000]
    with open(target + '.key', 'w') as f:
        f.write(key)
    return None


EMPTY = '''#include "golden.h"
const property properties[] = { { 0, 0, 0 } };
const golden goldens[] = { { 0, 0 } };
const golden truths[] = { { 0, 0 } };
'''
NO_MEMORY = '''#include <stddef.h>
size_t et_memory_cases(const char *folder) { return 0; }
int et_memory_fails(size_t k) { return 0; }
'''
SANITIZE = ['-fsanitize=address,undefined', '-fno-sanitize=vptr,alignment,float-cast-overflow,float-divide-by-zero', '-fno-sanitize-recover=undefined']


def wraps():
    """The linker's options for every call that tests/faults/memory.c takes upon itself."""
    names = sorted(set(re.findall(r'\b__wrap_(\w+)\(', read('tests/faults/memory.c').decode())))
    return ['-Wl,' + ','.join('--wrap=' + name for name in names)]


def build(o, units, phase):
    """The program with all mutants; its parts are compiled again when their text changes."""
    here = os.path.join(o.build, 'src_' + '_'.join(o.rooms))
    extra = o.extra + (SANITIZE if phase == 'asan' else [])
    write_if_new(os.path.join(here, 'empty.c'), EMPTY)
    write_if_new(os.path.join(here, 'nomemory.c'), NO_MEMORY)
    write_if_new(os.path.join(here, 'points.c'), tables(units))
    jobs = []
    headers = digest(*[read(p) for p in listed('include', 'src', 'tests', ends='.h')], *[u['text'] for u in units if u['path'].endswith('.h')])
    for u in units:
        write_if_new(os.path.join(here, u['path']), u['text'])
    flags = CFLAGS + extra + ['-I' + HERE, '-I' + os.path.join(here, 'src')] + FLAGS
    for u in units:
        if u['path'].endswith('.c'):
            jobs.append((os.path.join(here, u['path']), flags + ['-I' + os.path.dirname(u['path'])]))
    for room in o.rooms:        # files without a point are needed all the same
        for path in listed('src/' + room, ends='.c'):
            if path not in {u['path'] for u in units}:
                jobs.append((path, flags))
    jobs.append((os.path.join(here, 'points.c'), flags))
    jobs.append((os.path.join(HERE, 'run.c'), CFLAGS[1:] + extra + ['-O2', '-I' + HERE, '-Itests'] + FLAGS))
    jobs.append((os.path.join(HERE, 'memory.c') if phase == 'memory' else os.path.join(here, 'nomemory.c'), CFLAGS + FLAGS))
    if phase == 'memory':
        jobs.append((os.path.join(here, 'empty.c'), CFLAGS + ['-Itests'] + FLAGS))
    objects, faults = [], []
    lock, queue = threading.Lock(), list(jobs)

    def work():
        while True:
            with lock:
                if not queue:
                    return
                source, f = queue.pop()
            target = os.path.join(here, 'asan' if phase == 'asan' else 'o', re.sub(r'\W', '_', source) + '.o')
            fault = compile_one(o.cc, source, target, f, digest(read(source), headers, ' '.join(f)))
            with lock:
                objects.append(target)
                if fault:
                    faults.append('%s\n%s' % (source, fault))
    run_threads([work] * o.jobs)
    if faults:
        raise SystemExit('mutants: does not compile\n' + '\n'.join(faults))
    mine = tuple('/src/%s/' % r for r in o.rooms)
    others = [p for p in o.objects if not (any(r in p for r in mine) and p.endswith('.c.o')) and not p.endswith(('/tests/check.c.o', '/tests/shrink.c.o'))]
    if phase == 'memory':
        others = [p for p in others if ('/tests/' not in p or p.endswith(('/tests/gen.c.o', '/tests/golden.c.o'))) and not p.endswith('/registry.o')]
    program = os.path.join(here, 'run_' + phase)
    key = digest(*[read(p) for p in sorted(objects) + others])
    if not os.path.exists(program) or not os.path.exists(program + '.key') or read(program + '.key').decode() != key:
        done = subprocess.run([o.cc] + extra + (wraps() if phase == 'memory' else []) + ['-o', program] + sorted(objects) + others + o.libs.split(),
                              stderr=subprocess.PIPE, text=True)
        if done.returncode:
            raise SystemExit('mutants: %s cannot be linked\n%s' % (program, done.stderr[-2000:]))
        with open(program + '.key', 'w') as f:
            f.write(key)
    return program, others


def run_threads(works):
    threads = [threading.Thread(target=w, daemon=True) for w in works]
    for t in threads:
        t.start()
    for t in threads:
        while t.is_alive():
            t.join(0.2)


# Watching.

def unit_keys(o, program, units, others, phase):
    """What each unit of test depends on: the instrumented code, its own test file, its rows or cases."""
    code = digest(*[u['text'] for u in units], tables(units))
    common = digest(*[read(p) for p in others if '/tests/' not in p or re.search(r'/tests/(gen|golden)\.c\.o$', p)])
    text = {p: read(re.sub(r'^.*?/(tests/.*\.c)\.o$', r'\1', p)).decode('latin-1') for p in others if re.search(r'/tests/.*/test_\w+\.c\.o$', p)}
    where = {}
    for p, t in text.items():
        for kind, name in re.findall(r'^verdict (prop|gold|true)_([a-z0-9_]+)\(', t, re.M):
            where[kind, name] = p
    # What tests share is in files that hold none.
    common = digest(common, *[read(p) for p in sorted(text) if p not in where.values()])
    objects = {p: digest(read(p)) for p in text}
    tests = digest(*[objects[p] for p in sorted(objects)])
    keys = {}
    for line in subprocess.run([program, '--list'], stdout=subprocess.PIPE, text=True, check=True, env=environment(o, phase)).stdout.splitlines():
        name, module, cases = line.split('\t')
        if name == 'memory':
            keys[name] = digest(code, common, read('tests/faults/memory.c'))
        elif name.startswith(('golden.', 'truth.')):
            table = 'golden/%s.tsv' % name.split('.')[1]
            used = {f.split('\t')[0] for f in read(table).decode().splitlines() if f and not f.startswith('#')}
            own = [objects[where[k, f]] for k in (('gold',) if name.startswith('golden.') else ('true',)) for f in sorted(used) if (k, f) in where]
            keys[name] = digest(code, common, read(table), *own)
        else:
            prop = name[7:] if name.startswith('corpus.') else name
            own = objects[where['prop', prop]] if ('prop', prop) in where else tests
            files = [read(p) for p in o.corpus if os.path.basename(p).split('.')[0] == prop] if name.startswith('corpus.') else []
            keys[name] = digest(code, common, own, cases, *files)
    return keys


def environment(o, phase):
    env = dict(os.environ, OMP_NUM_THREADS='1', OPENBLAS_NUM_THREADS='1')
    env.pop('ET_RUNS', None)
    if phase == 'memory':
        env['ET_MEMORY'] = o.build
    else:
        env.update(ET_TABLES=' '.join(o.tables), ET_CORPUS=' '.join(o.corpus))
    if phase == 'asan':
        env.update(ET_RUNS='200', ET_SANITIZED='1', ASAN_OPTIONS='allocator_may_return_null=1:detect_leaks=1:handle_segv=0:leak_check_at_exit=0')
    if o.most:
        env['ET_MOST'] = str(o.most)
    return env


def watch(o, program, units, others, phase):
    folder = os.path.join(o.build, ('memory_' if phase == 'memory' else 'seen_') + '_'.join(o.rooms))
    os.makedirs(folder, exist_ok=True)
    keys = unit_keys(o, program, units, others, phase)
    todo = [n for n in keys if not os.path.exists(os.path.join(folder, n + '.seen')) or not os.path.exists(os.path.join(folder, n + '.key'))
            or read(os.path.join(folder, n + '.key')).decode() != keys[n]]
    if todo:
        say('watching %d of %d units of test' % (len(todo), len(keys)))
    done, bad, lock, began = [0], [], threading.Lock(), time.time()
    queue = list(reversed(todo))

    def work():
        while True:
            with lock:
                if not queue or stopping.is_set():
                    return
                name = queue.pop()
            p = subprocess.Popen([program, '--watch', folder, name], stdout=subprocess.PIPE, text=True, env=environment(o, phase), start_new_session=True)
            with lock:
                children.append(p)
            out = p.communicate()[0]
            with lock:
                children.remove(p)
                done[0] += 1
                if p.returncode and not stopping.is_set():
                    bad.append(out.strip())
                elif not p.returncode:
                    with open(os.path.join(folder, name + '.key'), 'w') as f:
                        f.write(keys[name])
                progress('watching', done[0], len(todo), began)
    run_threads([work] * o.jobs)
    if stopping.is_set():
        raise SystemExit(130)
    for b in bad:
        print(b)
    if bad and not o.go_on:
        raise SystemExit('mutants: %d units of test fail without any mutant' % len(bad))
    return folder, digest(*[k + keys[k] for k in sorted(keys)])


# Trying.

stopping = threading.Event()
children = []


def stop(*_):
    stopping.set()
    for c in list(children):
        try:
            os.killpg(c.pid, signal.SIGTERM)
        except OSError:
            pass


def say(text):
    print(text, flush=True)


last_told = [0.0]


def progress(what, done, of, began, extra=''):
    now = time.time()
    tty = sys.stderr.isatty()
    if now - last_told[0] < (0.2 if tty else 30) and done < of:
        return
    last_told[0] = now
    rate = done / max(now - began, 1e-9)
    left = (of - done) / rate if rate else 0
    text = '%s %d of %d, %.1f a second, %d:%02d left%s' % (what, done, of, rate, left // 60, left % 60, extra)
    sys.stderr.write('\r\x1b[K' + text + ('\n' if done == of else '') if tty else text + '\n')
    sys.stderr.flush()


def load_answers(path):
    answers = {}
    if os.path.exists(path):
        with open(path, encoding='latin-1') as f:
            for line in f:
                parts = line.rstrip('\n').split('\t')
                if len(parts) == 12:
                    answers.setdefault('\t'.join(parts[:5]), {})[parts[11]] = dict(source=parts[5], how=parts[6], unit=parts[7], case=int(parts[8]), spent=float(parts[9]), tests=parts[10])
    return answers


ALIVE = ('survived', 'budget', 'unreached')


def killed(m, answers):
    """The phase in which it was, or None."""
    for phase, a in answers.get(m['name'], {}).items():
        if a['source'] == m['source'] and a['how'] not in ALIVE:
            return phase
    return None


def try_all(o, program, seen, tests, mutants, answers, path, phase):
    todo = []
    for m in mutants:
        a = answers.get(m['name'], {}).get(phase)
        if phase != 'test' and killed(m, answers):
            continue
        if not o.fresh and a and a['source'] == m['source'] and (a['how'] not in ALIVE or a['tests'] == tests or o.keep):
            continue
        if o.unexplained and a and (explain(m, o.rules) or {}).get('kind') in SAME:
            continue
        todo.append(m)
    if not todo:
        return
    say({'test': 'trying %d mutants', 'memory': 'trying %d survivors where memory is refused', 'asan': 'trying %d survivors under the sanitizers'}[phase] % len(todo))
    by_number = {m['number']: m for m in mutants}
    queue = [m['number'] for m in reversed(todo)]
    lock, done, alive, began = threading.Lock(), [0], [0], time.time()
    out = open(path, 'a', encoding='latin-1')

    def work():
        env = environment(o, phase)
        p = subprocess.Popen([program, '--kill', seen, str(o.budget)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=env, start_new_session=True)
        with lock:
            children.append(p)
        while not stopping.is_set():
            with lock:
                if not queue:
                    break
                n = queue.pop()
            p.stdin.write('%d\n' % n)
            p.stdin.flush()
            line = p.stdout.readline().split()
            if len(line) != 5:
                break
            m = by_number[int(line[0])]
            a = dict(source=m['source'], how=line[1], unit=line[2], case=int(line[3]), spent=float(line[4]), tests=tests)
            with lock:
                answers.setdefault(m['name'], {})[phase] = a
                out.write('\t'.join([m['name'], a['source'], a['how'], a['unit'], str(a['case']), '%.3f' % a['spent'], tests, phase]) + '\n')
                out.flush()
                done[0] += 1
                alive[0] += a['how'] in ALIVE
                progress('tried', done[0], len(todo), began, ', %d survive' % alive[0])
        p.stdin.close()
        p.wait()
        with lock:
            children.remove(p)
    run_threads([work] * o.jobs)
    out.close()
    if stopping.is_set():
        say('stopped; what has been tried is kept')
        raise SystemExit(130)


# Telling.

KINDS = 'equivalent', 'memory', 'speed', 'unreachable', 'open'
SAME = KINDS[:-1]


def load_explained(path):
    """Place (file:function, or file); before -> after, `...` for anything, #N for the N-th of its kind, or `NAME commutes`; kind; reason."""
    rules = []
    if os.path.exists(path):
        with open(path, encoding='utf-8') as f:
            for n, line in enumerate(f, 1):
                line = line.rstrip('\n')
                if not line or line.startswith('#'):
                    continue
                parts = line.split('\t')
                if len(parts) != 4 or parts[2] not in KINDS:
                    raise SystemExit('%s:%d: four columns: file:function, before -> after, kind, reason' % (path, n))
                rules.append(dict(line=n, place=parts[0], change=parts[1], kind=parts[2], reason=parts[3], used=0))
    return rules


def explain(m, index):
    change = '%s -> %s' % (m['before'], m['after'])
    swapped = re.sub(r'\(.*', ' commutes', m['before']) if m['operator'] == 'arguments' else change
    for place in ('%s:%s' % (m['file'], m['function']), m['file']):
        for r in index.get(place, []):
            if r['change'] in ('%s #%d' % (change, m['which']), change, swapped) or '...' in r['change'] and (
                    wild(r['change']).fullmatch(change) or wild(r['change']).fullmatch('%s #%d' % (change, m['which']))):
                r['used'] += 1
                return r
    return None


@functools.lru_cache(None)
def wild(change):
    return re.compile('.*'.join(re.escape(p) for p in change.split('...')))


def index_of(rules):
    index = collections.defaultdict(list)
    for r in rules:
        index[r['place']].append(r)
    return index


def report(o, mutants, answers):
    rules = load_explained(o.explained)
    index = index_of(rules)
    per_file = collections.OrderedDict()
    counts, lines, told = collections.Counter(), [], []
    for m in mutants:
        a = answers.get(m['name'], {}).get('test')
        row = per_file.setdefault(m['file'], collections.Counter())
        how = 'untried' if a is None or a['source'] != m['source'] else 'by ' + killed(m, answers) if killed(m, answers) else 'alive'
        row['all'] += 1
        if how == 'alive':
            e = explain(m, index)
            told.append((m, e))
            how = e['kind'] if e else 'unexplained'
            if how in ('unexplained', 'open') or o.verbose:
                lines.append('%s:%d: %s: %s  ->  %s (%s)%s' % (m['file'], m['line'], m['function'], m['before'], m['after'], a['how'].replace('unreached', 'never differs'), ': ' + e['reason'] if e else ''))
        row[how] += 1
        counts[how] += 1
    same = sum(counts[k] for k in SAME)
    tried = len(mutants) - counts['untried']
    share = [100.0 * n / max(1, tried - same) for n in (counts['by test'], counts['by test'] + counts['by memory'] + counts['by asan'])]
    return per_file, counts, lines, share, [r for r in rules if not r['used']], told


def write_docs(path, o, mutants, answers, per_file, counts, share, told):
    """The part of the page between its two marks."""
    out = ['| file | mutants | killed by `make test` | by refused memory | by the sanitizers | equivalent | alive |', '|---|---|---|---|---|---|---|']
    for f, c in list(per_file.items()) + [('all', counts)]:
        out.append('| %s | %d | %d | %d | %d | %d | %d |' % (f, c['all'] if f != 'all' else len(mutants), c['by test'], c['by memory'], c['by asan'],
                                                            sum(c[k] for k in SAME), c['open'] + c['unexplained']))
    out += ['', 'Of those that are not equivalent `make test` kills %.1f %%, `make check` %.1f %%.' % tuple(share), '']
    by = collections.defaultdict(collections.Counter)
    for m in mutants:
        phase = killed(m, answers)
        by[m['operator']]['all'] += 1
        by[m['operator']]['killed'] += bool(phase)
    out += ['| operator | mutants | killed |', '|---|---|---|']
    out += ['| %s | %d | %d |' % (k, v['all'], v['killed']) for k, v in sorted(by.items())]
    out += ['', '## The survivors', '']
    now = None
    for m, rule in sorted(told, key=lambda t: (t[0]['file'], t[1]['line'] if t[1] else 0, t[0]['line'], t[0]['column'])):
        if m['file'] != now:
            now = m['file']
            out += ['### %s' % now, '']
            before = None
        reason = '%s: %s' % (rule['kind'], rule['reason']) if rule else 'not explained'
        if reason != before:
            if before is not None:
                out.append('')
            out += ['%s' % reason, '']
            before = reason
        out.append('* %d, %s: `%s` -> `%s`' % (m['line'], m['function'], m['before'], m['after']))
    text = read(path).decode()
    head, rest = text.split('<!-- made by make mutants -->')
    tail = rest.split('<!-- end of what make mutants made -->')[1]
    lines = []
    for line in out:
        lines.append(line if not line.startswith('### ') or not lines or lines[-1] == '' else '\n' + line)
    with open(path, 'w') as f:
        f.write(head + '<!-- made by make mutants -->\n' + '\n'.join(lines) + '\n<!-- end of what make mutants made -->' + tail)


def options():
    p = argparse.ArgumentParser()
    p.add_argument('--build', required=True)
    p.add_argument('--cc', default='gcc')
    p.add_argument('--extra', default='')
    p.add_argument('--objects', default='')
    p.add_argument('--libs', default='')
    p.add_argument('--rooms', default=' '.join(ROOMS))
    p.add_argument('--files', default='')
    p.add_argument('--sample', default='1/1')
    p.add_argument('--budget', type=float, default=5)
    p.add_argument('--most', type=int, default=0)
    p.add_argument('--jobs', type=int, default=os.cpu_count() or 1)
    p.add_argument('--phases', default='test memory asan')
    p.add_argument('--fresh', action='store_true')
    p.add_argument('--keep', action='store_true')
    p.add_argument('--unexplained', action='store_true')
    p.add_argument('--go-on', action='store_true')
    p.add_argument('--verbose', action='store_true')
    p.add_argument('--report', action='store_true')
    p.add_argument('--docs')
    p.add_argument('--explained', default=os.path.join(HERE, 'explained.tsv'))
    p.add_argument('--tables', default=None)
    p.add_argument('--corpus', default=None)
    o = p.parse_args()
    o.rooms = [r for r in ROOMS if r in o.rooms.split()] or o.rooms.split()
    o.files, o.objects, o.extra = o.files.split(), o.objects.split(), o.extra.split()
    o.tables = sorted(listed('golden', ends='.tsv')) if o.tables is None else o.tables.split()
    o.tables = [t for t in o.tables if os.path.dirname(t) == 'golden']
    o.corpus = sorted(os.path.join(d, f) for d, _, fs in os.walk('fuzz/corpus') for f in fs) if o.corpus is None else o.corpus.split()
    o.rules = index_of(load_explained(o.explained))
    a, b = o.sample.split('/')
    o.sample = int(a), int(b)
    return o


def selected(o, m):
    if o.files and not any(fnmatch.fnmatch(m['file'], f) or os.path.basename(m['file']) == f for f in o.files):
        return False
    return int(digest(m['name'])[:8], 16) % o.sample[1] < o.sample[0]


def main():
    o = options()
    os.makedirs(o.build, exist_ok=True)
    signal.signal(signal.SIGINT, stop)
    signal.signal(signal.SIGTERM, stop)
    units = []
    for room in o.rooms:
        units += units_of(o.build, room, [p for p in listed('src/' + room, ends='.c')])
    mutants = name_mutants(units)
    path = os.path.join(o.build, 'answers.tsv')
    answers = load_answers(path)
    chosen = [m for m in mutants if selected(o, m)]
    say('%d mutants in %d files%s' % (len(mutants), len(units), '' if len(chosen) == len(mutants) else ', %d chosen' % len(chosen)))
    if not o.report:
        seen = {}
        for phase in o.phases.split():
            program, others = build(o, units, phase)
            kind = 'memory' if phase == 'memory' else 'test'
            if kind not in seen:
                watcher, others = (program, others) if phase == kind else build(o, units, kind)
                seen[kind] = watch(o, watcher, units, others, kind)
            try_all(o, program, *seen[kind], chosen, answers, path, phase)
    per_file, counts, lines, share, unused, told = report(o, chosen, answers)
    if o.docs:
        write_docs(o.docs, o, chosen, answers, per_file, counts, share, told)
    for line in lines:
        print(line)
    print('%-30s %8s %8s %8s %8s %8s %8s' % ('file', 'mutants', 'killed', 'memory', 'asan', 'equal', 'alive'))
    for f, c in per_file.items():
        print('%-30s %8d %8d %8d %8d %8d %8d' % (f, c['all'], c['by test'], c['by memory'], c['by asan'], sum(c[k] for k in SAME),
                                                 c['open'] + c['unexplained']))
    same = sum(counts[k] for k in SAME)
    print('%d mutants: %d killed by make test, %d by refused memory, %d by the sanitizers, %d equivalent, %d known to be open, %d unexplained, %d not tried'
          % (len(chosen), counts['by test'], counts['by memory'], counts['by asan'], same, counts['open'], counts['unexplained'], counts['untried']))
    print('%.2f %% of those that are not equivalent are killed by make test, %.2f %% by make check' % tuple(share))
    if counts['unexplained']:
        print('FAIL mutants: %d survivors that tests/mutants/explained.tsv does not explain' % counts['unexplained'])
        raise SystemExit(1)
    print('ok mutants')


if __name__ == '__main__':
    main()
