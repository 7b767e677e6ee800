// Lets a Pioneer search in a square spiral until its sonars detect an obstacle, and says where.
// Usage: Spiral -rh 10.0.0.5, or -rp /dev/ttyUSB0
#include <cstdio>
#include "Aria.h"

static bool isNear(ArRobot &robot)
{
  return robot.checkRangeDevicesCurrentPolar(-30, 30) - robot.getRobotRadius() < 400;
}

// Drives straight until an obstacle is near; returns whether it is.
static bool drive(ArRobot &robot, double mm)
{
  robot.lock();
  robot.move(mm);
  robot.unlock();
  bool found = false;
  bool done = false;
  while (!done) {
    ArUtil::sleep(50);
    robot.lock();
    found = isNear(robot);
    if (found)
      robot.stop();
    done = robot.isMoveDone() && robot.isStopped();
    robot.unlock();
  }
  return found;
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
  for (double side = 300; side < 2500 && !drive(robot, side); side += 150)
    turn(robot, 90);
  ArPose end = robot.getPose();
  printf("the search ended at %.0f %.0f\n", end.getX(), end.getY());
  robot.stopRunning();
  robot.waitForRunExit();
  Aria::exit(0);
}
