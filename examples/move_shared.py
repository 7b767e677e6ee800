"""Prints the states of a robot that MAJIC shares, and moves it by MM: move_shared.py BROKER SITE DESK ROBOT MM"""
import json, sys, uuid
from paho.mqtt import properties, subscribe
broker, site, desk, number, mm = sys.argv[1:] if len(sys.argv) == 6 else sys.exit(__doc__)
robot, replies = f"{site}/majic/1/desks/{desk}/robots/{number}", f"{site}/majic/1/replies/{uuid.uuid4().hex}"
session = uuid.uuid4().hex  # secret: a program that knows it can move the robot that this one holds
request = properties.Properties(properties.PacketTypes.PUBLISH)
request.ResponseTopic, request.CorrelationData, request.MessageExpiryInterval = replies, b"1", 2
todo = [("request", {"number": 1, "do": "move", "mm": float(mm)})]

def received(client, data, message):
    print(content := json.loads(message.payload))
    if content.get("outcome", "accepted") != "accepted":
        client.disconnect()
    elif "clock" in content and not message.retain:  # "hold" is the heartbeat, without which the robot is halted after 1 s
        topic, command = todo.pop() if todo else ("hold", {})
        sent = {"desk": "python", "session": session, "validUntil": content["clock"] + 700, **command}
        client.publish(f"{robot}/{topic}", json.dumps(sent), 1, properties=request)

subscribe.callback(received, [robot + "/state", robot + "/changes", replies], 1, hostname=broker, protocol=5, clean_session=None)
