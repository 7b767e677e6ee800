"""Moves a robot that MAJIC shares, and prints the answers: move_shared.py BROKER SITE DESK ROBOT MM"""
import json
import sys
import threading
import time
import uuid

from paho.mqtt import subscribe
from paho.mqtt.client import CallbackAPIVersion, Client, MQTTv5
from paho.mqtt.properties import PacketTypes, Properties

broker, site, desk, number, mm = sys.argv[1:]
robot = f"{site}/majic/1/desks/{desk}/robots/{number}"
replies = f"{site}/majic/1/replies/{uuid.uuid4().hex}"
session = uuid.uuid4().hex  # secret: a program that knows it can move the robot that this one holds
state = json.loads(subscribe.simple(f"{robot}/state", hostname=broker, retained=False).payload)
clock = state["clock"] - time.monotonic() * 1000  # the desk's clock minus this computer's, ms
done = threading.Event()


def received(client, data, message):
    answer = json.loads(message.payload)
    print(answer)
    if answer["outcome"] != "accepted":
        done.set()


def send(topic, valid_ms, properties=None, **content):
    message = {"session": session, "validUntil": int(clock + time.monotonic() * 1000 + valid_ms), **content}
    client.publish(f"{robot}/{topic}", json.dumps(message), 1, properties=properties)


client = Client(CallbackAPIVersion.VERSION2, protocol=MQTTv5)
client.on_message = received
client.connect(broker)
client.subscribe(replies, 1)
client.loop_start()
request = Properties(PacketTypes.PUBLISH)
request.ResponseTopic, request.CorrelationData, request.MessageExpiryInterval = replies, b"1", 2
send("request", 1000, request, number=1, do="move", mm=float(mm))
while not done.wait(0.25):
    send("hold", 700)  # without this heartbeat the robot is halted after 1 s
client.disconnect()
