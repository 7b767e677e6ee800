// Lets a Pioneer wander by the actions that are part of ARIA.
// Usage: Actions -rh 10.0.0.5, or -rp /dev/ttyUSB0
#include "Aria.h"

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
  ArActionStallRecover recover;
  ArActionAvoidFront avoid("avoid", 500, 200);
  ArActionConstantVelocity ahead("ahead", 400);
  robot.addAction(&recover, 100);
  robot.addAction(&avoid, 50);
  robot.addAction(&ahead, 25);
  robot.enableMotors();
  robot.run(true);
  Aria::exit(0);
}
