// Signatures of what the programs in examples/native use of ARIA, written for this purpose from its documentation. The
// build checks the programs against them; nothing of ARIA itself is here.
#pragma once

class ArRobot;

class Aria {
public:
  static void init();
  static bool parseArgs();
  static void logOptions();
  [[noreturn]] static void exit(int status);
};

class ArUtil {
public:
  static void sleep(unsigned int ms);
};

class ArTime {
public:
  ArTime();
  long mSecSince() const;
};

class ArPose {
public:
  double findDistanceTo(ArPose other) const;
  double getX() const;
  double getY() const;
};

class ArArgumentParser {
public:
  ArArgumentParser(int *argc, char **argv);
  void loadDefaultArguments();
};

class ArRobotConnector {
public:
  ArRobotConnector(ArArgumentParser *arguments, ArRobot *robot);
  bool connectRobot();
};

class ArRangeDevice {};

class ArSonarDevice : public ArRangeDevice {
public:
  ArSonarDevice();
};

class ArAction {};

class ArActionStallRecover : public ArAction {
public:
  ArActionStallRecover();
};

class ArActionAvoidFront : public ArAction {
public:
  ArActionAvoidFront(const char *name, double obstacleDistance, double avoidVelocity);
};

class ArActionConstantVelocity : public ArAction {
public:
  ArActionConstantVelocity(const char *name, double velocity);
};

class ArRobot {
public:
  ArRobot();
  void addRangeDevice(ArRangeDevice *device);
  bool addAction(ArAction *action, int priority);
  void run(bool stopRunIfNotConnected);
  void runAsync(bool stopRunIfNotConnected);
  void stopRunning();
  void waitForRunExit();
  int lock();
  int unlock();
  void enableMotors();
  void move(double mm);
  void stop();
  void setDeltaHeading(double degrees);
  void setVel(double mmPerSec);
  void setRotVel(double degPerSec);
  bool isMoveDone() const;
  bool isHeadingDone() const;
  bool isStopped() const;
  bool isConnected() const;
  ArPose getPose() const;
  double getRobotRadius() const;
  double checkRangeDevicesCurrentPolar(double fromDeg, double toDeg) const;
};

class ArSocket {
public:
  enum Type { TCP, UDP };
  ArSocket();
  bool connect(const char *host, int port, Type type);
  int writeString(const char *format, ...);
  char *readString();
  bool close();
};

class ArSerialConnection {
public:
  ArSerialConnection();
  bool setBaud(int baud);
  int open(const char *port);
  int write(const char *data, unsigned int size);
  int read(char *data, unsigned int size, unsigned int waitMs);
  bool close();
};
