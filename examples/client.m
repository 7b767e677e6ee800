function answers = client(port, tokenFile, varargin)
%CLIENT Sends lines to a running MAJIC and returns its answers.
%   client(7777, 'listen-7777.token', '2 move 500', '2 get x,y')
    majic = tcpclient('127.0.0.1', port);
    lines = [{strtrim(fileread(tokenFile))}, varargin, {'wait', 'help quit'}];
    write(majic, uint8([strjoin(lines, newline), newline]));
    answers = '';
    while isempty(strfind(answers, 'help: quit'))  % the answer to the last line
        pause(0.05);
        count = majic.NumBytesAvailable;
        if count > 0
            answers = [answers, char(read(majic, count))];
        end
    end
    answers = regexprep(answers, 'help: quit.*', '');
    clear majic                                    % closes the connection
end
