"""Does with roslibpy what RosDriver does with MAJIC's driver: subscribes to the same topics, publishes a velocity 20
times a second while driving, and zero three times to stop. Arguments: host, port, velocity topic, its type, the
subscriptions as JSON, and the times of RosDriver: settling, measured, driving and standing in ms, the rounds."""

import json
import math
import sys
import threading
import time

import roslibpy

host, port, topic, topic_type, subscriptions = sys.argv[1:6]
settling_ms, measured_ms, driving_ms, standing_ms, rounds = map(int, sys.argv[6:11])
PERIOD_S = 0.05
RATE = math.radians(30)

ros = roslibpy.Ros(host, int(port))
ros.run()
newest = {}
for wanted in json.loads(subscriptions):
    name = wanted["topic"]
    roslibpy.Topic(
        ros, name, wanted["type"], throttle_rate=wanted.get("throttle_rate", 0), queue_length=wanted.get("queue_length", 0)
    ).subscribe(lambda message, name=name: newest.__setitem__(name, message))
velocity = roslibpy.Topic(ros, topic, topic_type)
velocity.advertise()


def publish(rate):
    twist = {"linear": {"x": 0.0}, "angular": {"z": rate}}
    velocity.publish(roslibpy.Message({"header": {}, "twist": twist} if topic_type.endswith("Stamped") else twist))


def drive(count):
    for number in range(count):
        rate = RATE if number % 2 == 0 else -RATE
        print("drive", time.monotonic_ns())
        publish(rate)
        end = time.monotonic() + driving_ms / 1000
        while time.monotonic() + PERIOD_S < end:
            time.sleep(PERIOD_S)
            publish(rate)
        print("stop", time.monotonic_ns())
        publish(0.0)
        for _ in range(2):
            time.sleep(PERIOD_S)
            publish(0.0)
        time.sleep(standing_ms / 1000 - 2 * PERIOD_S)


def percent_since(began):
    return 100 * (time.process_time() - began[1]) / (time.monotonic() - began[0])


def now():
    return time.monotonic(), time.process_time()


time.sleep(settling_ms / 1000)
began = now()
time.sleep(measured_ms / 1000)
print("reporting", percent_since(began))
drive(rounds // 8)
began = now()
drive(rounds)
print("driven", percent_since(began))
ros.close()
threading.Timer(0.2, ros.terminate).start()
