#!/usr/bin/env python3
"""Every header of the package includes what it names of the standard library and of CGAL, itself or in the header that it implements, and
reaches the headers of the package whose classes it names, without what only implements another.

What is missing shows up only in the program that includes that header first, and the tests, which share much of what they include, are
no such program.

usage: test_includes.py SOURCE_FOLDER [FOLDER_OF_CGAL_HEADERS]
"""

import pathlib
import re
import sys

STANDARD = {
    "algorithm": "all_of any_of binary_search clamp copy count_if equal fill fill_n find find_if generate is_sorted lower_bound max"
                 " max_element min min_element minmax minmax_element none_of nth_element partition pop_heap push_heap remove_if reverse"
                 " rotate set_difference sort stable_partition stable_sort swap_ranges transform unique upper_bound",
    "array": "array",
    "atomic": "atomic",
    "charconv": "from_chars to_chars",
    "chrono": "chrono",
    "cmath": "abs acos atan atan2 cbrt ceil cos exp floor fma hypot isfinite isnan log lround pow sin sqrt tan",
    "complex": "complex",
    "cstddef": "byte ptrdiff_t size_t",
    "cstdint": "int32_t int64_t uint16_t uint32_t uint64_t uint8_t",
    "cstring": "memcmp memcpy strlen",
    "deque": "deque",
    "exception": "current_exception exception exception_ptr rethrow_exception",
    "fstream": "ifstream ofstream",
    "functional": "function greater hash invoke less ref cref reference_wrapper",
    "initializer_list": "initializer_list",
    "iterator": "advance back_inserter distance iterator_traits make_move_iterator next prev",
    "limits": "numeric_limits",
    "map": "map multimap",
    "memory": "make_shared make_unique shared_ptr unique_ptr weak_ptr",
    "mutex": "lock_guard mutex scoped_lock unique_lock",
    "new": "bad_alloc",
    "numeric": "accumulate inner_product iota partial_sum reduce",
    "optional": "nullopt optional",
    "queue": "priority_queue queue",
    "random": "mt19937 mt19937_64",
    "set": "multiset set",
    "sstream": "istringstream ostringstream stringstream",
    "stdexcept": "invalid_argument logic_error out_of_range runtime_error",
    "string": "stod string to_string",
    "string_view": "string_view",
    "thread": "thread",
    "tuple": "make_tuple tie tuple",
    "type_traits": "conditional_t decay_t enable_if_t false_type is_arithmetic_v is_base_of_v is_invocable_v is_same_v is_void_v"
                   " remove_cv_t remove_reference_t true_type void_t",
    "unordered_map": "unordered_map",
    "unordered_set": "unordered_set",
    "utility": "declval exchange forward make_pair move pair swap",
    "variant": "variant visit",
    "vector": "vector",
}


def names_of_header(folder_of_cgal):
    """Which header each name is of."""
    headers = {"std::" + name: header for header, names in STANDARD.items() for name in names.split()}
    if folder_of_cgal:
        # CGAL names its headers after the class or function in it.
        headers.update({"CGAL::" + file.stem: "CGAL/" + file.name for file in pathlib.Path(folder_of_cgal).glob("*.h")})
    return headers


def included(text):
    return set(re.findall(r"^\s*#\s*include <([^>]+)>", text, re.MULTILINE))


def reached(header, includes):
    """The headers of the package that one includes, itself or through others."""
    seen = {header}
    todo = [header]
    while todo:
        for other in includes[todo.pop()]:
            if other in includes and other not in seen and not other.endswith("_impl.h"):
                seen.add(other)
                todo.append(other)
    return seen


def unreached_classes(texts):
    """Sentences on the classes of the package, each in a header of its name, that a header names but does not reach."""
    of_class = {}
    for header in texts:
        of_class.setdefault(pathlib.Path(header).stem, set()).add(header)
    includes = {header: included(text) for header, text in texts.items()}
    for header, text in sorted(texts.items()):
        code = re.sub(r"/\*.*?\*/", "", re.sub(r"//.*|\"[^\"\n]*\"|^\s*#.*$", "", text, flags=re.MULTILINE), flags=re.DOTALL)
        declared = set(re.findall(r"\b(?:class|struct|typename) (\w+)", code))
        seen = reached(header, includes)
        for name in sorted(set(re.findall(r"(?<![\w.>])[A-Z]\w+", code)) - declared):
            if name in of_class and not of_class[name] & seen:
                yield f"{header}: {name} needs <{min(of_class[name])}>"


def main():
    root = pathlib.Path(sys.argv[1]) / "include"
    headers = names_of_header(sys.argv[2] if len(sys.argv) > 2 else None)
    ours = {file.stem for file in root.rglob("*.h")}
    # The package is within namespace CGAL and may leave that out; a name of three words can hardly be something else.
    unqualified = {name[6:]: header for name, header in headers.items()
                   if re.match(r"CGAL::[A-Z]\w*_\w*_", name) and name[6:] not in ours}
    failures = []
    files = sorted(root.rglob("*.h"))
    if not files:
        sys.exit("There are no headers in " + str(root) + ".")
    for file in files:
        text = file.read_text(encoding="utf-8")
        includes = included(text)
        if file.name.endswith("_impl.h"):
            implemented = file.with_name(file.name[:-len("_impl.h")] + ".h")
            if implemented.exists():
                includes |= included(implemented.read_text(encoding="utf-8"))
        code = re.sub(r"//.*|\"[^\"\n]*\"|^\s*#.*$", "", text, flags=re.MULTILINE)
        declared = set(re.findall(r"\b(?:class|struct) (\w+);", code))
        named = {name: headers[name] for name in set(re.findall(r"\b(?:std|CGAL)::\w+", code)) if name in headers}
        named.update({name: unqualified[name] for name in set(re.findall(r"(?<![\w:.>])[A-Z]\w+", code)) if name in unqualified})
        for name, header in sorted(named.items()):
            if header not in includes and name.split("::")[-1] not in declared:
                failures.append(f"{file.relative_to(root)}: {name} needs <{header}>")
    failures.extend(unreached_classes({str(file.relative_to(root)): file.read_text(encoding="utf-8") for file in files}))
    print("\n".join(failures))
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
