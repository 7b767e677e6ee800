"""Sends lines to a MAJIC on another computer: tls_client.py HOST PORT CERTIFICATE TOKENFILE LINE..."""
import socket
import ssl
import sys

host, port, certificate, token_file, *script = sys.argv[1:] if len(sys.argv) > 4 else sys.exit(__doc__)
context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
context.check_hostname = False  # the certificate belongs to one MAJIC, whatever its address
context.load_verify_locations(certificate)  # and no other certificate is accepted
try:
    with socket.create_connection((host, int(port))) as plain, context.wrap_socket(plain) as majic:
        lines = majic.makefile("rw", encoding="utf-8", newline="\n")
        lines.write(open(token_file).read())  # the token and a line end
        for line in script:
            lines.write(line + "\n")
        lines.write("close\n")  # no more lines: MAJIC closes after the last answer
        lines.flush()
        for answer in lines:
            print(answer, end="")
except ssl.SSLCertVerificationError as error:
    sys.exit(f"{host}: {error.verify_message}; {certificate} must be the newest listen.pem of MAJIC there")
