"""Prints time and value of a parameter from a recording: recording.py FILE ROBOT PARAMETER"""
import gzip
import sys

file, robot, parameter = sys.argv[1:] if len(sys.argv) == 4 else sys.exit(__doc__)
time = "0"
with gzip.open(file, "rt", encoding="utf-8", newline="\n") as lines:
    try:
        for line in lines:
            columns = line.rstrip("\n").split("\t")
            time = columns[0] or time  # no time: that of the line before
            if columns[1:4] == ["value", robot, parameter]:
                print(time, columns[4])
    except EOFError:
        pass  # MAJIC still writes the file, or was killed
