"""Prints the states of a robot that MAJIC shares, until Ctrl-C: watch_shared.py BROKER SITE DESK ROBOT"""
import json
import sys

from paho.mqtt.client import CallbackAPIVersion, Client, MQTTv5

broker, site, desk, robot = sys.argv[1:] if len(sys.argv) == 5 else sys.exit(__doc__)


def received(client, data, message):
    state = json.loads(message.payload)
    print(state["connection"], state["pose"], state["values"].get("voltage"))


client = Client(CallbackAPIVersion.VERSION2, protocol=MQTTv5)
client.on_message = received
client.connect(broker)
client.subscribe(f"{site}/majic/1/desks/{desk}/robots/{robot}/state")
client.loop_forever()
