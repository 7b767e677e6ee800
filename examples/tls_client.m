function answers = tls_client(host, port, certificateFile, tokenFile, varargin)
%TLS_CLIENT Sends lines to a MAJIC on another computer and returns its answers.
%   tls_client('10.0.0.5', 7777, 'listen.pem', 'listen-7777.token', '2 move 500')
    pem = javaObject('java.io.FileInputStream', certificateFile);
    certificates = javaMethod('getInstance', 'java.security.cert.CertificateFactory', 'X.509');
    store = javaMethod('getInstance', 'java.security.KeyStore', 'PKCS12');
    store.load([], []);
    store.setCertificateEntry('majic', certificates.generateCertificate(pem));
    trust = javaMethod('getInstance', 'javax.net.ssl.TrustManagerFactory', 'PKIX');
    trust.init(store);                             % no other certificate is accepted
    context = javaMethod('getInstance', 'javax.net.ssl.SSLContext', 'TLSv1.3');
    context.init([], trust.getTrustManagers(), []);
    majic = context.getSocketFactory().createSocket(host, port);
    lines = [{strtrim(fileread(tokenFile))}, varargin, {'close', ''}];
    out = javaObject('java.io.PrintStream', majic.getOutputStream(), true, 'UTF-8');
    out.print(strjoin(lines, newline));
    out.flush();
    in = javaObject('java.util.Scanner', majic.getInputStream(), 'UTF-8');
    answers = '';
    while in.hasNextLine()                         % until MAJIC closes, after the last answer
        answers = [answers, char(in.nextLine()), newline];
    end
    majic.close();
end
