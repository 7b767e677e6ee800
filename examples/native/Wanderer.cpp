// Lets a Pioneer wander by its sonars: ahead until an obstacle is near, then to the side with more room.
// Usage: Wanderer -rh 10.0.0.5, or -rp /dev/ttyUSB0
#include <cstdio>
#include "Aria.h"

static double roomBetween(ArRobot &robot, double fromDeg, double toDeg)
{
  return robot.checkRangeDevicesCurrentPolar(fromDeg, toDeg) - robot.getRobotRadius();
}

static void driveAhead(ArRobot &robot)
{
  robot.lock();
  ArPose start = robot.getPose();
  robot.move(2000);
  robot.unlock();
  bool done = false;
  while (!done) {
    ArUtil::sleep(50);
    robot.lock();
    if (roomBetween(robot, -30, 30) < 500)
      robot.stop();
    done = robot.isMoveDone() && robot.isStopped();
    robot.unlock();
  }
  printf("ahead %.0f mm\n", robot.getPose().findDistanceTo(start));
}

static void turnToTheFreeSide(ArRobot &robot)
{
  robot.lock();
  double degrees = roomBetween(robot, 60, 120) > roomBetween(robot, -120, -60) ? 100 : -100;
  robot.setDeltaHeading(degrees);
  robot.unlock();
  bool done = false;
  while (!done) {
    ArUtil::sleep(50);
    robot.lock();
    done = robot.isHeadingDone() && robot.isStopped();
    robot.unlock();
  }
  printf("turned %.0f deg\n", degrees);
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
  for (int leg = 0; leg < 5; leg++) {
    driveAhead(robot);
    turnToTheFreeSide(robot);
  }
  robot.stopRunning();
  robot.waitForRunExit();
  Aria::exit(0);
}
