"""Writes the tables of docs/large_systems.md between their marks.

    page.py PAGE FOLDER

The folder holds the rows of all rounds, a name and seconds, in SYSTEM.SIZE.THREADS.tsv, and the lines of `peak` in
peak.json. The least time of a name counts.
"""

import json
import pathlib
import re
import sys

page, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])


def least(path):
    times = {}
    for line in path.read_text().splitlines():
        name, seconds = line.split("\t")
        times[name] = min(float(seconds), times.get(name, float("inf")))
    return times


def files(system):
    found = [(*map(int, path.name.split(".")[1:3]), least(path)) for path in folder.glob(f"{system}.*.tsv")]
    return sorted(found, key=lambda row: row[:2])


def lattices():
    out = ["| spins | threads | floor | C++ by hand | `LatticeMidpoint` | floor/ours | ours/C++ | `SphericalMidpoint` |",
           "|--:|--:|--:|--:|--:|--:|--:|--:|"]
    for size, threads, t in files("lattice"):
        floor, peer, fast, general = (t[name] for name in ("triad", "C++", "LatticeMidpoint", "SphericalMidpoint"))
        times = [f"{1e3 * seconds:.3g} ms" for seconds in (floor, peer, fast)]
        out.append(f"| {size}³ | {threads} | {' | '.join(times)} | {floor / fast:.2f} | {fast / peer:.2f} | {1e3 * general:.3g} ms |")
    return out


def vortices():
    peak = max(json.loads(line)["gflops"] for line in (folder / "peak.json").read_text().splitlines())
    out = ["| vortices | threads | C++ pairs | field | a sweep | field/C++ | sweep/C++ | of the FMA peak |",
           "|--:|--:|--:|--:|--:|--:|--:|--:|"]
    for count, threads, t in files("vortices"):
        pairs, field, sweep = (t[name] for name in ("C++ pairs", "field", "SphericalMidpoint"))
        times = [f"{1e3 * seconds:.3g} ms" for seconds in (pairs, field, sweep)]
        share = 12e-9 * count**2 / field / peak / threads
        out.append(f"| {count} | {threads} | {' | '.join(times)} | {field / pairs:.2f} | {sweep / pairs:.2f} | {share:.2f} |")
    return out


def main():
    with open("/proc/cpuinfo") as info:
        names = [line.split(":")[1].strip() for line in info if line.startswith("model name")]
    text = page.read_text()
    for mark, lines in (("lattices", lattices()), ("vortices", vortices())):
        lines += ["", f"Measured on {len(names)} processors {names[0] if names else ''}."]
        table = f"<!-- {mark}: begin -->\n\n" + "\n".join(lines) + f"\n<!-- {mark}: end -->"
        text = re.sub(rf"<!-- {mark}: begin -->.*<!-- {mark}: end -->", lambda _: table, text, flags=re.S)
    page.write_text(text)


main()
