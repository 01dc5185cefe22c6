# blender/make_zip.py: the add-on as the file that Blender's preferences install; the same sources give the same bytes.
"""Usage: make_zip.py OUT.zip"""
import pathlib
import sys
import zipfile

FOLDER = pathlib.Path(__file__).resolve().parent / "sinew_blender"
DATE = (1980, 1, 1, 0, 0, 0)


def main():
    with zipfile.ZipFile(sys.argv[1], "w") as out:
        for path in sorted(FOLDER.glob("*.py")):
            entry = zipfile.ZipInfo("sinew_blender/" + path.name, DATE)
            entry.compress_type, entry.external_attr = zipfile.ZIP_STORED, 0o100644 << 16
            out.writestr(entry, path.read_bytes())


if __name__ == "__main__":
    main()
