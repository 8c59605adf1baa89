# SPDX-License-Identifier: BSD-3-Clause
"""Command line of contact_campaign."""
import argparse
from collections import Counter

from ..arguments import Parser
from ..command import Failure, finish
from .campaign import Campaign
from .cluster import connect
from .folder import Folder, record_of, require_same
from .plan import INPUTS, plan_of
from .work import DAMAGED, FEW_RESULTS

SLICE = 20000
UNUSABLE_INPUT = ("INVALID_INPUT", "NO_TRANSFORM")  # statuses; with each other status, the input was usable


def main(arguments=None):
    """Runs the command and returns its exit status."""
    return finish("contact_campaign", _run, _parser().parse_args(arguments))


def _run(options):
    folder = Folder(options.out)
    with folder.opened() as before:
        plan = plan_of(options, before)
        if before:
            require_same(plan, before)
        folder.write_manifest(plan)
        try:
            failures = _evaluate(options, plan, folder)
        finally:
            folder.write_manifest(plan)
        faults = _report(plan, folder)
        poor = _report_poor(plan, folder)
        if failures:
            raise Failure("\n  ".join([f"{len(failures)} tasks failed; the same command repeats them:", *failures]))
        folder.clear()
        return FEW_RESULTS if poor else DAMAGED if faults else 0


def _evaluate(options, plan, folder):
    """Does the remaining work. @return failures, as sentences"""
    if all(record_of(folder.results(name)) for name in plan["bags"]):
        return []
    with connect(options.scheduler) as client:
        campaign = Campaign(client, plan, folder)
        campaign.run()
        return campaign.failures


def _report(plan, folder):
    """Prints a summary of the results, as contact_replay does. @return parts that could not be read, as sentences"""
    slices = [record for name in plan["bags"] for record in (record_of(folder.results(name)) or {"done": []})["done"]]
    for note in dict.fromkeys(note for record in slices for note in record["notes"]):
        print(note)
    print(f"{sum(record['results'] for record in slices)} results of {len(plan['bags'])} bags in {folder.path}")
    for status, count in sum((Counter(record["statuses"]) for record in slices), Counter()).items():
        print(f"  {status}: {count}")
    dropped = Counter()
    for record in slices:
        for inputs, count, reason in record["dropped"]:
            dropped[inputs, reason] += count
    for (inputs, reason), count in dropped.items():
        print(f"  {inputs}: {count} messages dropped: {reason}")
    for topic, count in sum((Counter(record["lacking_neighbour"]) for record in slices), Counter()).items():
        print(f"  {topic}: {count} results lack a neighbour's forces")
    faults = list(dict.fromkeys(fault for record in slices for fault in record["faults"]))
    for fault in faults:
        print(f"  {fault}")
    return faults


def _report_poor(plan, folder):
    """Prints the bags in which fewer than half of the poses have a result of usable input. @return their number"""
    poor = 0
    for name in plan["bags"]:
        slices = (record_of(folder.results(name)) or {"done": []})["done"]
        results, poses = (sum(record[key] for record in slices) for key in ("results", "poses"))
        results -= sum(record["statuses"].get(status, 0) for record in slices for status in UNUSABLE_INPUT)
        if 2 * results < poses:
            print(f"  {name}: only {results} of {poses} poses have a result of usable input")
            poor += 1
    return poor


def _slice(text):
    count = int(text)
    if count < 1:
        raise argparse.ArgumentTypeError(f"{text}: must be at least 1")
    return count


def _parser():
    parser = Parser(
        prog="contact_campaign", description="Evaluates bags as contact_replay does, on every core of this machine or "
        "on the workers of a Dask scheduler. Long bags are divided into slices, and the results of the slices are joined. "
        "Each file is identical to that of contact_replay. After an interruption, the same command continues. See "
        "doc/campaign.md.")
    parser.add_argument("bags", nargs="+", metavar="BAG", help="bag to evaluate")
    parser.add_argument("--out", required=True, metavar="DIR", help="folder for the results and manifest.json")
    parser.add_argument("--scheduler", metavar="tcp://HOST:PORT", help="address of a Dask scheduler (default: a local one)")
    parser.add_argument("--slice", type=_slice, default=SLICE, metavar="N",
                        help="approximate number of results in a slice (default: %(default)s)")
    parser.add_argument("--config", action="append", default=[], metavar="F.yaml",
                        help="path of a parameter file, applied over the defaults and over the files given before")
    parser.add_argument("--wheelset", nargs="+", default=[], metavar="NAME",
                        help="namespaces of several wheelsets, as in contact_replay")
    for name in INPUTS:
        parser.add_argument(f"--{name}", metavar="TOPIC", help="name of this input topic, as in contact_replay")
    parser.add_argument("--keep-topics", action="store_true",
                        help="copy the other messages of the bags, as in contact_replay")
    parser.add_argument("--no-grids", action="store_true", help="omit the pressure grids, as in contact_replay")
    parser.add_argument("--lz4", action="store_true", help="compress the bags of results, as in contact_replay")
    return parser
