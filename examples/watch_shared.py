"""Shows what a robot does that MAJIC shares over a broker, and moves it: watch_shared.py BROKER SITE DESK ROBOT [MM]"""
import json
import sys
import time
import uuid

import paho.mqtt.client as mqtt
from paho.mqtt.packettypes import PacketTypes
from paho.mqtt.properties import Properties

broker, site, desk, number = sys.argv[1:5]
robot = f"{site}/majic/1/desks/{desk}/robots/{number}"
me = {"session": uuid.uuid4().hex, "desk": "python", "person": "Pia"}
replies = f"{site}/majic/1/replies/{me['session']}"
last = {"outcome": "accepted"}
clock = None  # the robot's clock less ours, ms


def received(client, data, message):
    global clock, last
    content = json.loads(message.payload)
    if message.topic == replies:
        last = content
        print("answer:", content)
    elif not message.retain:
        clock = content["clock"] - time.monotonic() * 1000
        print(content["pose"], content["connection"], content["values"].get("voltage"))


def valid(ms):
    return int(clock + time.monotonic() * 1000 + ms)


client = mqtt.Client(mqtt.CallbackAPIVersion.VERSION2, protocol=mqtt.MQTTv5)
client.on_message = received
host, _, port = broker.partition(":")
client.connect(host, int(port or 1883))
client.subscribe([(f"{robot}/state", 0), (replies, 1)])
client.loop_start()
while clock is None:
    time.sleep(0.1)
if len(sys.argv) > 5:
    request = Properties(PacketTypes.PUBLISH)
    request.ResponseTopic, request.CorrelationData, request.MessageExpiryInterval = replies, b"1", 2
    move = {**me, "number": 1, "validUntil": valid(1000), "do": "move", "mm": float(sys.argv[5])}
    client.publish(f"{robot}/request", json.dumps(move), 1, properties=request)
while len(sys.argv) <= 5 or last["outcome"] == "accepted":
    if len(sys.argv) > 5:  # without this heartbeat the robot is halted
        client.publish(f"{robot}/hold", json.dumps({**me, "validUntil": valid(700)}))
    time.sleep(0.25)
client.disconnect()
