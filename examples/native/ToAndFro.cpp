// Lets three different robots patrol between two points each, three times; each turns where it finds an obstacle.
// Usage: ToAndFro -rh PIONEER AIBO HEMISSON, such as ToAndFro -rh 10.0.0.5 192.168.1.20 /dev/ttyUSB0
#include <cstdio>
#include <cstring>
#include <thread>
#include "Aria.h"

static const int LEGS = 6;

// Runs commands of the Aibo and waits for their end.
static bool run(ArSocket &aibo, const char *commands)
{
  aibo.writeString("patrol+end: { %s },", commands);
  const char *line = aibo.readString();
  while (line && !strstr(line, "patrol] *** end"))
    line = aibo.readString();
  return line;
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

// Sets the speeds of the Hemisson for a time; ends early at an obstacle if asked to.
static bool drive(ArSerialConnection &hemisson, const char *speeds, int ms, bool untilObstacle)
{
  char answer[80];
  int front = 0;
  ArTime start;
  bool alive = ask(hemisson, speeds, 'd', answer, sizeof answer);
  while (alive && start.mSecSince() < ms && !(untilObstacle && front >= 60)) {
    alive = ask(hemisson, "N\r", 'n', answer, sizeof answer) && sscanf(answer, "n,%d", &front) == 1;
    ArUtil::sleep(50);
  }
  return ask(hemisson, "D,0,0\r", 'd', answer, sizeof answer) && alive;
}

static bool hemissonLeg(ArSerialConnection &hemisson)
{
  return drive(hemisson, "D,3,3\r", 11900, true) && drive(hemisson, "D,-2,2\r", 5900, false);
}

static bool pioneerLeg(ArRobot &pioneer)
{
  pioneer.lock();
  pioneer.move(500);
  pioneer.unlock();
  bool done = false;
  while (!done) {
    ArUtil::sleep(50);
    pioneer.lock();
    if (pioneer.checkRangeDevicesCurrentPolar(-30, 30) - pioneer.getRobotRadius() < 500)
      pioneer.stop();
    done = pioneer.isMoveDone() && pioneer.isStopped();
    pioneer.unlock();
  }
  pioneer.lock();
  pioneer.setDeltaHeading(180);
  pioneer.unlock();
  done = false;
  while (!done) {
    ArUtil::sleep(50);
    pioneer.lock();
    done = pioneer.isHeadingDone() && pioneer.isStopped();
    pioneer.unlock();
  }
  return pioneer.isConnected();
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

  bool alive = true;
  for (int leg = 0; leg < LEGS && alive; leg++) {
    bool dog = false, small = false;
    std::thread first([&] { dog = run(aibo, "stopif (distance.val < 25) robot.walk(6s); robot.turn(5040)"); });
    std::thread second([&] { small = hemissonLeg(hemisson); });
    alive = pioneerLeg(pioneer);
    first.join();
    second.join();
    alive = alive && dog && small;
  }
  printf("%s\n", alive ? "done" : "a robot was lost");

  aibo.close();
  hemisson.close();
  pioneer.stopRunning();
  pioneer.waitForRunExit();
  Aria::exit(0);
}
