// Lets three different robots race over half a metre; a robot with an obstacle ahead stops earlier.
// Usage: GreatRace -rh PIONEER AIBO HEMISSON, such as GreatRace -rh 10.0.0.5 192.168.1.20 /dev/ttyUSB0
#include <cstdio>
#include <cstring>
#include <thread>
#include "Aria.h"

// Runs commands of the Aibo and waits for their end.
static bool run(ArSocket &aibo, const char *commands)
{
  aibo.writeString("race+end: { %s },", commands);
  const char *line = aibo.readString();
  while (line && !strstr(line, "race] *** end"))
    line = aibo.readString();
  return line;
}

static void raceAibo(ArSocket &aibo)
{
  bool arrived = run(aibo, "stopif (distance.val < 30) robot.walk(6s)");
  printf("Aibo: %s\n", arrived ? "arrived" : "lost");
}

// Sends a command to the Hemisson and reads its answer, which must begin with this letter.
static bool ask(ArSerialConnection &hemisson, const char *command, char letter, char *answer, int size)
{
  hemisson.write(command, strlen(command));
  int count = 0;
  while (count < size - 1 && hemisson.read(answer + count, 1, 500) == 1)
    if (answer[count++] == '\n')
      break;
  answer[count] = '\0';
  return answer[0] == letter;
}

static void raceHemisson(ArSerialConnection &hemisson)
{
  char answer[80];
  int front = 0;
  ArTime start;
  bool arrived = ask(hemisson, "D,3,3\r", 'd', answer, sizeof answer);
  while (arrived && start.mSecSince() < 11900 && front < 60) {
    arrived = ask(hemisson, "N\r", 'n', answer, sizeof answer) && sscanf(answer, "n,%d", &front) == 1;
    ArUtil::sleep(50);
  }
  arrived &= ask(hemisson, "D,0,0\r", 'd', answer, sizeof answer);
  printf("Hemisson: %s\n", arrived ? "arrived" : "lost");
}

static void racePioneer(ArRobot &pioneer)
{
  pioneer.lock();
  pioneer.move(500);
  pioneer.unlock();
  bool done = false;
  while (!done) {
    ArUtil::sleep(50);
    pioneer.lock();
    if (pioneer.checkRangeDevicesCurrentPolar(-30, 30) - pioneer.getRobotRadius() < 300)
      pioneer.stop();
    done = pioneer.isMoveDone() && pioneer.isStopped();
    pioneer.unlock();
  }
  printf("Pioneer: %s\n", pioneer.isConnected() ? "arrived" : "lost");
}

int main(int argc, char **argv)
{
  Aria::init();
  ArArgumentParser arguments(&argc, argv);
  arguments.loadDefaultArguments();
  ArRobot pioneer;
  ArRobotConnector connector(&arguments, &pioneer);
  if (!connector.connectRobot() || !Aria::parseArgs() || argc != 3) {
    Aria::logOptions();
    Aria::exit(1);
  }
  ArSonarDevice sonar;
  pioneer.addRangeDevice(&sonar);
  pioneer.runAsync(true);
  pioneer.lock();
  pioneer.enableMotors();
  pioneer.unlock();

  ArSocket aibo;
  if (!aibo.connect(argv[1], 54000, ArSocket::TCP) || !run(aibo, "motors on; robot.stand()")) {
    printf("the Aibo at %s does not answer\n", argv[1]);
    Aria::exit(1);
  }

  ArSerialConnection hemisson;
  hemisson.setBaud(115200);
  if (hemisson.open(argv[2]) != 0) {
    printf("cannot open %s\n", argv[2]);
    Aria::exit(1);
  }

  std::thread first([&] { raceAibo(aibo); });
  std::thread second([&] { raceHemisson(hemisson); });
  racePioneer(pioneer);
  first.join();
  second.join();

  aibo.close();
  hemisson.close();
  pioneer.stopRunning();
  pioneer.waitForRunExit();
  Aria::exit(0);
}
