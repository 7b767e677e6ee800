// Lets a Pioneer follow the wall on its right by its sonars, half a metre away.
// Usage: Wall -rh 10.0.0.5, or -rp /dev/ttyUSB0
#include <algorithm>
#include "Aria.h"

static const double AWAY_MM = 500;
static const int PIECES = 100;

static double roomBetween(ArRobot &robot, double fromDeg, double toDeg)
{
  return robot.checkRangeDevicesCurrentPolar(fromDeg, toDeg) - robot.getRobotRadius();
}

static void turn(ArRobot &robot, double degrees)
{
  robot.lock();
  robot.setDeltaHeading(degrees);
  robot.unlock();
  bool done = false;
  while (!done) {
    ArUtil::sleep(50);
    robot.lock();
    done = robot.isHeadingDone() && robot.isStopped();
    robot.unlock();
  }
}

static bool isBlocked(ArRobot &robot)
{
  robot.lock();
  bool blocked = roomBetween(robot, -30, 30) < AWAY_MM;
  robot.unlock();
  return blocked;
}

int main(int argc, char **argv)
{
  Aria::init();
  ArArgumentParser arguments(&argc, argv);
  arguments.loadDefaultArguments();
  ArRobot robot;
  ArRobotConnector connector(&arguments, &robot);
  if (!connector.connectRobot() || !Aria::parseArgs()) {
    Aria::logOptions();
    Aria::exit(1);
  }
  ArSonarDevice sonar;
  robot.addRangeDevice(&sonar);
  robot.runAsync(true);
  robot.lock();
  robot.enableMotors();
  robot.unlock();
  ArUtil::sleep(1000);
  robot.lock();
  robot.setVel(300);
  robot.unlock();
  while (!isBlocked(robot))
    ArUtil::sleep(50);
  double before = AWAY_MM;
  for (int piece = 0; piece < PIECES; piece++) {
    while (isBlocked(robot))
      turn(robot, 30);
    robot.lock();
    double now = std::min(roomBetween(robot, -120, -60), 2 * AWAY_MM);
    double rate = (AWAY_MM - now) / 20 - (now - before) / 4;
    robot.setVel(150);
    robot.setRotVel(std::clamp(rate, -25.0, 25.0));
    robot.unlock();
    ArUtil::sleep(1000);
    before = now;
  }
  robot.lock();
  robot.stop();
  robot.unlock();
  ArUtil::sleep(1000);
  robot.stopRunning();
  robot.waitForRunExit();
  Aria::exit(0);
}
