# SPDX-License-Identifier: BSD-3-Clause
"""Command line of contact_campaign."""
import argparse
from collections import Counter

from ..command import Failure, finish
from .campaign import Campaign
from .cluster import connect
from .folder import Folder, record_of, require_same
from .plan import plan_of
from .work import DAMAGED

SLICE = 20000


def main(arguments=None):
    """Run the command; returns its exit status."""
    return finish("contact_campaign", _run, _parser().parse_args(arguments))


def _run(options):
    folder = Folder(options.out)
    with folder.opened() as before:
        plan = plan_of(options, before)
        if before:
            require_same(plan, before)
        folder.write_manifest(plan)
        try:
            failures = _answer(options, plan, folder)
        finally:
            folder.write_manifest(plan)
        faults = _report(plan, folder)
        if failures:
            raise Failure("\n  ".join([f"{len(failures)} tasks failed; the same command tries them again:", *failures]))
        folder.clear()
        return DAMAGED if faults else 0


def _answer(options, plan, folder):
    """Does what is left to do. @return what failed, in sentences."""
    if all(record_of(folder.answers(name)) for name in plan["bags"]):
        return []
    with connect(options.scheduler) as client:
        campaign = Campaign(client, plan, folder)
        campaign.run()
        return campaign.failures


def _report(plan, folder):
    """Tells what stands in the answers, as contact_replay does. @return what could not be read, in sentences."""
    slices = [record for name in plan["bags"] for record in (record_of(folder.answers(name)) or {"done": []})["done"]]
    print(f"{sum(record['answers'] for record in slices)} answers of {len(plan['bags'])} bags in {folder.path}")
    for status, count in sum((Counter(record["statuses"]) for record in slices), Counter()).items():
        print(f"  {status}: {count}")
    dropped = Counter()
    for record in slices:
        for inputs, count, reason in record["dropped"]:
            dropped[inputs, reason] += count
    for (inputs, reason), count in dropped.items():
        print(f"  {inputs}: {count} messages dropped: {reason}")
    for answers, count in sum((Counter(record["lacking_neighbour"]) for record in slices), Counter()).items():
        print(f"  {answers}: {count} answers lack a neighbour's forces")
    faults = list(dict.fromkeys(fault for record in slices for fault in record["faults"]))
    for fault in faults:
        print(f"  {fault}")
    return faults


def _slice(text):
    count = int(text)
    if count < 1:
        raise argparse.ArgumentTypeError(f"{text}: must be at least 1")
    return count


def _parser():
    parser = argparse.ArgumentParser(
        prog="contact_campaign", description="Answers bags as contact_replay does, on every core of this machine or on the "
        "workers of a Dask scheduler. Long bags are cut into slices, whose answers are joined: each file is the one that "
        "contact_replay writes. The same command goes on where an earlier one was broken off. See doc/campaign.md.")
    parser.add_argument("bags", nargs="+", metavar="BAG", help="bag to answer")
    parser.add_argument("--out", required=True, metavar="DIR", help="folder for the answers and manifest.json")
    parser.add_argument("--scheduler", metavar="tcp://HOST:PORT", help="Dask scheduler (default: one of its own)")
    parser.add_argument("--slice", type=_slice, default=SLICE, metavar="N",
                        help="answers in a slice, about (default: %(default)s)")
    parser.add_argument("--config", action="append", default=[], metavar="F.yaml",
                        help="path of a parameter file, laid over the defaults and the files given before")
    parser.add_argument("--wheelset", nargs="+", default=[], metavar="NAME", help="as contact_replay takes it")
    parser.add_argument("--keep-topics", action="store_true", help="likewise")
    parser.add_argument("--no-grids", action="store_true", help="likewise")
    parser.add_argument("--lz4", action="store_true", help="likewise")
    return parser
