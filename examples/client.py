"""Sends lines to a running MAJIC and prints its answers: client.py PORT TOKENFILE LINE..."""
import socket
import sys

port, token_file, *script = sys.argv[1:] if len(sys.argv) > 2 else sys.exit(__doc__)
with socket.create_connection(("127.0.0.1", int(port))) as majic:
    lines = majic.makefile("rw", encoding="utf-8", newline="\n")
    lines.write(open(token_file).read())  # the token and a line end
    for line in script:
        lines.write(line + "\n")
    lines.flush()
    majic.shutdown(socket.SHUT_WR)  # no more lines: MAJIC closes after the last answer
    for answer in lines:
        print(answer, end="")
