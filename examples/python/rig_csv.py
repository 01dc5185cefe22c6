# examples/python/rig_csv.py: the muscles of a rig as a table for a spreadsheet, and back.
"""rig_csv.py out RIG TABLE.csv: writes a line for each muscle.
rig_csv.py in RIG TABLE.csv OUT.rig.json: sets what the table says; lines of new names are new muscles, and muscles that have
no line are removed. Twins follow each other: of two that the table changes, the later line counts."""
import csv
import sys

import sinew

WORDS = ("bone", "group")
NUMBERS = ("reach", "amount", "core", "belly")
VECTORS = {"center": "xyz", "radii": "xyz", "rotation": "xyzw", "bend": "xz"}
COLUMNS = ("name", *WORDS, "sign", *NUMBERS, *("%s.%s" % (field, axis) for field in VECTORS for axis in VECTORS[field]))


def row_of(muscle):
    row = {name: getattr(muscle, name) for name in ("name", *WORDS, "sign", *NUMBERS)}
    for field, axes in VECTORS.items():
        row.update(("%s.%s" % (field, axis), value) for axis, value in zip(axes, getattr(muscle, field)))
    return row


def number(row, column):
    try:
        return float(row[column])
    except ValueError:
        raise sinew.Error("expected a number, got %r" % row[column], place="muscle %r, %s" % (row["name"], column))


def fields_of(row):
    fields = {name: row[name] for name in WORDS}
    fields["sign"] = int(number(row, "sign"))
    fields.update((name, number(row, name)) for name in NUMBERS)
    fields.update((field, [number(row, "%s.%s" % (field, axis)) for axis in axes]) for field, axes in VECTORS.items())
    return fields


def write(rig_file, table):
    with open(table, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, COLUMNS)
        writer.writeheader()
        writer.writerows(row_of(muscle) for muscle in sinew.load_rig(rig_file))


def read(rig_file, table, out):
    rig = sinew.load_rig(rig_file)
    with open(table, newline="", encoding="utf-8") as file:
        reader = csv.DictReader(file)
        if reader.fieldnames is None or set(COLUMNS) - set(reader.fieldnames):
            raise sinew.Error("expected the columns " + ", ".join(COLUMNS), file=table)
        rows = list(reader)
    before = {muscle.name: row_of(muscle) for muscle in rig}
    for name in set(before) - {row["name"] for row in rows}:
        rig.remove(name)
    for row in rows:
        if row["name"] not in before:
            rig.add_muscle(row["name"], **fields_of(row))
            continue
        muscle, was = rig[row["name"]], before[row["name"]]
        for field, value in fields_of(row).items():
            columns = [column for column in COLUMNS if column.split(".")[0] == field]
            if any(str(was[column]) != row[column] for column in columns):
                setattr(muscle, field, value)
    rig.save(out)


if __name__ == "__main__":
    try:
        {"out": write, "in": read}[sys.argv[1]](*sys.argv[2:])
    except sinew.Error as error:
        sys.exit("rig_csv: %s" % error)
