"""Prints the states of a robot that MAJIC shares, and moves it: watch_shared.py BROKER SITE DESK ROBOT [MM]"""
import json
import sys
import time
import uuid

from paho.mqtt.client import CallbackAPIVersion, Client, MQTTv5
from paho.mqtt.properties import PacketTypes, Properties

broker, site, desk, number, *mm = sys.argv[1:]
robot = f"{site}/majic/1/desks/{desk}/robots/{number}"
sender = {"session": uuid.uuid4().hex, "desk": "python", "person": "Pia"}
replies = f"{site}/majic/1/replies/{sender['session']}"
clock = None  # the desk's clock minus this computer's, ms


def received(client, data, message):
    global clock
    content = json.loads(message.payload)
    if message.topic == replies:
        print("answer:", content)
        if content["outcome"] != "accepted":
            client.disconnect()
    elif not message.retain:
        clock = content["clock"] - time.monotonic() * 1000
        print(content["pose"], content["connection"], content["values"].get("voltage"))


def send(topic, qos, valid_ms, properties=None, **content):
    valid_until = int(clock + time.monotonic() * 1000 + valid_ms)
    message = json.dumps({**sender, "validUntil": valid_until, **content})
    client.publish(f"{robot}/{topic}", message, qos, properties=properties)


client = Client(CallbackAPIVersion.VERSION2, protocol=MQTTv5)
client.on_message = received
client.connect(broker)
client.subscribe([(f"{robot}/state", 0), (replies, 1)])
client.loop_start()
while clock is None:
    time.sleep(0.1)
if mm:
    request = Properties(PacketTypes.PUBLISH)
    request.ResponseTopic, request.CorrelationData, request.MessageExpiryInterval = replies, b"1", 2
    send("request", 1, 1000, request, number=1, do="move", mm=float(mm[0]))
while client.is_connected():
    if mm:
        send("hold", 0, 700)  # without this heartbeat the robot is halted after 1 s
    time.sleep(0.25)
