"""What Metal's compiler rejects in the MSL of spirv-cross, found by reading: constructs that users of MoltenVK and SPIRV-Cross met.

No compiler of Metal runs here: a text without these faults is not proven to compile.
"""
import re

# What Metal's library has of what the wind's text calls, and what looks like a call and is none.
LIBRARY = {"abs", "ceil", "clamp", "cos", "cross", "distance", "dot", "exp", "exp2", "fabs", "fast", "floor", "fma", "fmax", "fmin",
           "fract", "length", "level", "log", "log2", "max", "min", "mix", "normalize", "pow", "precise", "read", "rsqrt", "sample",
           "select", "sign", "sin", "smoothstep", "sqrt", "step", "tan", "as_type"}
NO_CALL = {"if", "for", "while", "switch", "return", "sizeof", "buffer", "texture", "sampler", "user", "attribute", "position",
           "function_constant"}
TYPES = re.compile(r"(packed_)?(bool|char|uchar|short|ushort|int|uint|half|float)([234](x[234])?)?$|texture\dd(_array)?$|sampler$")
RESERVED = {"vertex", "fragment", "kernel", "constant", "device", "thread", "threadgroup", "half", "sampler", "access", "using",
            "template", "class", "new", "delete", "this", "operator", "namespace", "private", "public", "protected", "union"}

# (pattern, what is wrong, where it was met)
PATTERNS = [
    (r"\bdouble\b", "double: Metal has no 64-bit floats", "MSL 2.1, types"),
    (r"unsupported-built-in-type|/\* *FIXME|#error", "spirv-cross could not say this in MSL", "SPIRV-Cross, CompilerMSL"),
    (r"\bspvArrayCopy\w*\s*\(", "an array copied between address spaces", "SPIRV-Cross issues 1647, 2582"),
    (r"\bspvUnsafeArray<", "an array as a value, whose assignment may not exist", "SPIRV-Cross issues 1726, 2511"),
    (r"\[\s*\](?!\])", "an array without a size", "MSL 2.1, arrays"),
    (r"\w\s*\[0u?\]\s*;\s*$", "an array of no elements", "MSL 2.1, arrays"),
    (r"as_type<\w+>\([^;]*2147483648", "a bit cast of a long: -2147483648 is no int", "SPIRV-Cross issue 1813, MoltenVK issue 1476"),
    (r"\bdfdx\w*\(|\bdfdy\w*\(|\bfwidth\w*\(", "a derivative outside of a fragment function", "MSL 2.1, fragment functions"),
    (r"\bvariable-length|\balloca\b|\bgoto\b", "C that MSL lacks", "MSL 2.1, restrictions"),
]


def arguments_from(text, at):
    """The arguments behind the opening bracket at `at`, split at commas of their own level."""
    depth, start, parts = 0, at + 1, []
    for n in range(at, len(text)):
        if text[n] in "([{":
            depth += 1
        elif text[n] in ")]}":
            depth -= 1
            if depth == 0:
                return [part.strip() for part in [*parts, text[start:n]] if part.strip()]
        elif text[n] == "," and depth == 1:
            parts.append(text[start:n])
            start = n + 1
    return parts


def functions_of(text):
    """{name: (parameters, body)} of the functions that the text defines."""
    found = {}
    for match in re.finditer(r"^(?!struct|using|#)[\w ]+?[ ](\w+)\(", text, re.M):
        parameters = arguments_from(text, match.end() - 1)
        opening = text.find("\n{", match.end())
        closing = text.find("\n}", opening)
        between = text[match.end():opening]
        if opening > 0 and ";" not in between:
            found[match.group(1)] = (parameters, text[opening:closing])
    return found


def calls_in(body):
    """Name and arguments of each call that is no method's."""
    for match in re.finditer(r"(?<![\w.])(?:\w+::)*(\w+)\s*(?:<[\w ]+>)?\(", body):
        yield match.group(1), arguments_from(body, match.end() - 1)


def recursive(functions):
    """Functions that come to call themselves."""
    graph = {name: {called for called, _ in calls_in(body) if called in functions} for name, (_, body) in functions.items()}
    found = []
    for name in graph:
        seen, waiting = set(), list(graph[name])
        while waiting:
            here = waiting.pop()
            if here not in seen:
                seen.add(here)
                waiting.extend(graph[here])
        if name in seen:
            found.append(name)
    return found


def address_space_faults(functions):
    """References without an address space, and arguments whose space is not the parameter's."""
    for name, (parameters, body) in functions.items():
        spaces = {}
        for parameter in parameters:
            if re.search(r"[&*]", parameter):
                space = re.search(r"\b(thread|device|constant|threadgroup)\b", parameter)
                if not space:
                    yield f"{name}: the reference `{parameter}` has no address space (MSL 2.1, address spaces)"
                else:
                    spaces[re.sub(r"\s*\[\[.*", "", parameter).split()[-1].lstrip("&*")] = space.group(1)
        for called, arguments in calls_in(body):
            for parameter, argument in zip(functions.get(called, ([], ""))[0], arguments):
                wanted = re.search(r"\b(thread|device|constant|threadgroup)\b.*[&*]", parameter)
                path = re.match(r"(\w+)(?:\.\w+|\[[^\]]*\])*$", argument)
                given = spaces.get(path.group(1)) if path else None
                if wanted and given and wanted.group(1) != given:
                    yield (f"{name}: `{argument}` is in {given}, and {called} takes it in {wanted.group(1)} "
                           "(SPIRV-Cross issues 1647, 2294)")


def msl_faults(text):
    """A sentence for each fault."""
    text = re.sub(r"//[^\n]*", "", text)
    functions = functions_of(text)
    faults = []
    for pattern, wrong, source in PATTERNS:
        faults.extend(f"`{match.group(0).strip()}`: {wrong} ({source})" for match in re.finditer(pattern, text, re.M))
    if not re.search(r"^(vertex|fragment|kernel) ", text, re.M):
        faults.append("no entry point (MoltenVK issue 112)")
    constants = set(re.findall(r"\bconstant \w+ (\w+) \[\[function_constant", text))
    constants |= set(re.findall(r"\bconstant \w+ (\w+) = is_function_constant_defined", text))
    for name in sorted(constants):
        if re.search(rf"^\s*(threadgroup |const )?\w+ \w+\[[^\]]*\b{name}\b[^\]]*\]\s*;", text, re.M):
            faults.append(f"an array of {name} elements, which is a function constant (SPIRV-Cross issues 671, 2511; MoltenVK issue 231)")
    for type_name, name in re.findall(r"\b((?:packed_)?(?:float|int|uint|bool|half)[234]?) (\w+)\b", text):
        if name in RESERVED:
            faults.append(f"`{type_name} {name}`: a word of MSL as a name (MoltenVK issue 112, SPIRV-Cross issue 513)")
    for name in recursive(functions):
        faults.append(f"{name} calls itself (MSL 2.1, restrictions)")
    faults.extend(address_space_faults(functions))
    structs = set(re.findall(r"^struct (\w+)", text, re.M))
    known = LIBRARY | NO_CALL | set(functions) | structs
    for name, (_, body) in functions.items():
        faults.extend(f"{name}: {called} is neither defined here nor a function of Metal" for called, _ in calls_in(body)
                      if called not in known and not TYPES.match(called))
        faults.extend(f"{name}: `{match.group(0)}` samples without a level outside of a fragment function (MSL 2.1, sampling)"
                      for match in re.finditer(r"\.sample\([^;]*;", body)
                      if "level(" not in match.group(0) and "fragment " not in text)
    for parameters, _ in functions.values():
        places = re.findall(r"\[\[((?:buffer|texture|sampler)\(\d+\))\]\]", " ".join(parameters))
        faults.extend(f"{place} is taken twice (MSL 2.1, attributes)" for place in {p for p in places if places.count(p) > 1})
    for struct in re.findall(r"^struct \w+_(?:out|in)\n\{(.*?)\n\};", text, re.M | re.S):
        faults.extend(f"`{member.strip()}` between stages is of no type that Metal hands on (MSL 2.1, stage input)"
                      for member in struct.splitlines() if re.search(r"\bbool\b|\w\[\d+\]\s*(\[\[|;)|\b(float|half)\dx\d\b", member))
    return faults
