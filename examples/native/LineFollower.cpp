// Lets a Hemisson follow the left edge of a dark line until an obstacle is near.
// Usage: LineFollower /dev/ttyUSB0
#include <cstdio>
#include <fcntl.h>
#include <termios.h>

static int openPort(const char *path)
{
  int port = open(path, O_RDWR | O_NOCTTY);
  if (port < 0)
    return port;
  termios settings;
  tcgetattr(port, &settings);
  cfmakeraw(&settings);
  cfsetspeed(&settings, B115200);
  settings.c_cc[VMIN] = 0;
  settings.c_cc[VTIME] = 50;
  tcsetattr(port, TCSANOW, &settings);
  return port;
}

// Sends a command and reads its answer, which must begin with this letter.
static bool ask(int port, FILE *answers, const char *command, char letter, char *answer, int size)
{
  dprintf(port, "%s\r", command);
  return fgets(answer, size, answers) && answer[0] == letter;
}

int main(int argc, char **argv)
{
  if (argc != 2) {
    fprintf(stderr, "usage: LineFollower PORT\n");
    return 2;
  }
  int port = openPort(argv[1]);
  if (port < 0) {
    perror(argv[1]);
    return 1;
  }
  FILE *answers = fdopen(port, "r");
  char answer[80];
  int front, frontRight, frontLeft, right, left, rear, groundRight, groundLeft;
  while (ask(port, answers, "N", 'n', answer, sizeof answer)
      && sscanf(answer, "n,%d,%d,%d,%d,%d,%d,%d,%d", &front, &frontRight, &frontLeft, &right, &left, &rear,
             &groundRight, &groundLeft) == 8
      && front < 60) {
    if (!ask(port, answers, groundRight < 90 ? "D,2,4" : "D,4,2", 'd', answer, sizeof answer))
      break;
  }
  bool stopped = ask(port, answers, "D,0,0", 'd', answer, sizeof answer);
  fclose(answers);
  return stopped ? 0 : 1;
}
