#!/bin/busybox sh
# Process 1 of the guest: walks media_vcan_check through the life of a CAN interface, then canopen-gateway through that of
# a CANopen node, which cgw verify examines, and prints what they and candump have seen, each file behind a line "== name".
/bin/busybox --install -s /bin
export PATH=/bin ASAN_OPTIONS=detect_leaks=0
mkdir -p /proc /sys /dev /tmp
mount -t proc proc /proc
mount -t sysfs sysfs /sys
mount -t devtmpfs devtmpfs /dev
mkdir -p /dev/pts
mount -t devpts devpts /dev/pts

say() { echo "$*" >>/tmp/progress; }
finish() {
  for file in progress refused check candump burst serial adapter gateway node node_again state verify; do
    echo "== $file"
    cat /tmp/$file 2>/dev/null
  done
  echo "== end"
  poweroff -f
}
fail() {
  say "failed: $*"
  finish
}
# Until `file` has `count` lines that match `pattern`.
wait_for() { # file count pattern
  tries=0
  until [ "$(grep -c -- "$3" /tmp/$1)" -ge "$2" ]; do
    tries=$((tries + 1))
    [ $tries -lt 300 ] || fail "no '$3' ($2) in $1"
    sleep 0.1
  done
}
# Until `count` sockets listen on vcan0.
wait_for_listeners() { # count
  tries=0
  until [ "$(grep -c vcan0 /proc/net/can/rcvlist_all)" -ge "$1" ]; do
    tries=$((tries + 1))
    [ $tries -lt 300 ] || fail "$1 listeners do not come"
    sleep 0.1
  done
}
record() { # file [listeners, itself among them]
  candump -L vcan0 >/tmp/$1 2>/dev/null &
  recorder=$!
  wait_for_listeners ${2:-2}
}
stop_recording() {
  kill $recorder
  wait $recorder
}

touch /tmp/progress /tmp/refused /tmp/check /tmp/candump /tmp/burst /tmp/serial /tmp/adapter /tmp/gateway /tmp/node /tmp/node_again /tmp/verify
media_vcan_check vcan0 >>/tmp/refused 2>&1
for module in can can-raw can-dev vcan sch_tbf; do
  insmod /modules/$module.ko || fail "insmod $module"
done
media_vcan_check vcan0 >>/tmp/refused 2>&1
media_vcan_check lo >>/tmp/refused 2>&1
say "refusals seen"

ip link add dev vcan0 type vcan || fail "ip link add"
media_vcan_check vcan0 >/tmp/check 2>&1 &
check=$!
wait_for check 1 'down vcan0: the interface is down'
ip link set vcan0 up
wait_for check 1 'up vcan0: the interface is up'

record candump
cansend vcan0 123#1122334455667788
wait_for candump 1 124#1122334455667788
cansend vcan0 00012345#01
wait_for candump 1 00012346#01
cansend vcan0 200#R
wait_for candump 1 201#R
cansend vcan0 000#
wait_for candump 1 ' 001#'
stop_recording
say "frames exchanged"

ip link set vcan0 down
wait_for check 2 'down vcan0: the interface is down'
ip link set vcan0 up
wait_for check 2 'up vcan0: the interface is up'
cansend vcan0 130#01
wait_for check 1 'frame 130#01'
say "down and up"

# What came before the interface went down is not lost.
kill -STOP $check
cansend vcan0 7A2#
ip link set vcan0 down
kill -CONT $check
wait_for check 3 'down vcan0: the interface is down'
ip link set vcan0 up
wait_for check 3 'up vcan0: the interface is up'
say "down behind a frame"

ip link del vcan0
wait_for check 1 'down vcan0: there is no such interface'
ip link add dev vcan0 type vcan
ip link set vcan0 up
wait_for check 4 'up vcan0: the interface is up'
cansend vcan0 132#02
wait_for check 1 'frame 132#02'
say "removed and added"

# What a real controller's driver says; a virtual interface carries error frames as well.
cansend vcan0 20000004#0010000000000000
wait_for check 1 'error-passive'
cansend vcan0 20000004#0040000000000000
wait_for check 1 'error-active again'
cansend vcan0 20000004#0001000000000000
wait_for check 1 'lost 1$'
cansend vcan0 20000040#0000000000000000
wait_for check 1 'bus-off'
wait_for check 5 'up vcan0: the interface is up'
say "controller reports"

# More frames than the kernel keeps for a program that does not take them. Its count comes with the next frame.
kill -STOP $check
cangen vcan0 -g 0 -I 7A0 -L 0 -n 5000
kill -CONT $check
wait_for check 1 'frame 7A0#'
sleep 0.5
cansend vcan0 7A1#
wait_for check 1 'frame 7A1#'
say "flooded"

# An interface whose queue takes a few frames, and then no more for a while.
# By its path: the shell would take busybox's own tc.
record burst
/bin/tc qdisc add dev vcan0 root tbf rate 8kbit burst 100 limit 64 || fail "tc"
cansend vcan0 7F0#
wait_for burst 20 ' 500#'
/bin/tc -s qdisc show dev vcan0 | tr '\n' ' ' >>/tmp/progress
echo >>/tmp/progress
stop_recording

cansend vcan0 7FF#
wait $check
say "ended with $?"
/bin/tc qdisc del dev vcan0 root

# A serial adapter: slcanpty of can-utils speaks slcan on a pseudo terminal, with vcan0 behind it.
plug_in() {
  slcanpty /dev/ptmx vcan0 >/dev/null 2>&1 &
  adapter=$!
  tries=0
  until [ -e /dev/pts/0 ]; do
    tries=$((tries + 1))
    [ $tries -lt 300 ] || fail "slcanpty does not come"
    sleep 0.1
  done
}
plug_in
media_vcan_check /dev/pts/0 250 >/tmp/serial 2>&1 &
check=$!
wait_for serial 1 'up /dev/pts/0'
record adapter
cansend vcan0 123#1122334455667788
wait_for adapter 1 124#1122334455667788
cansend vcan0 00012345#01
wait_for adapter 1 00012346#01
cansend vcan0 200#R
wait_for adapter 1 201#R
stop_recording
kill $adapter
wait_for serial 1 'down /dev/pts/0: the adapter is gone'
plug_in
wait_for serial 2 'up /dev/pts/0'
cansend vcan0 7FF#
wait $check
say "serial ended with $?"

# The gateway itself, node 12, with candump and cansend as its master.
record node 1
canopen-gateway --can2 socketcan:vcan0 --state /tmp/state >/tmp/gateway 2>&1 &
gateway=$!
wait_for gateway 1 'state Pre-Operational'
wait_for node 1 ' 70C#00'
cansend vcan0 60C#4018100100000000
wait_for node 1 ' 58C#43181001'
cansend vcan0 60C#2B171000F4010000
wait_for node 1 ' 58C#80171000'
cansend vcan0 000#010C
wait_for gateway 1 'state Operational'
wait_for node 3 ' 48C#'
stop_recording
say "gateway Operational"
cgw verify /plant.toml --live socketcan:vcan0 >/tmp/verify 2>&1
say "verify ended with $?"

ip link set vcan0 down
wait_for gateway 1 'CAN2 down: vcan0: the interface is down'
wait_for gateway 1 'error 3072 ErrCanBus2'
ip link set vcan0 up
wait_for gateway 2 'CAN2 up: vcan0: the interface is up'
record node_again
wait_for node_again 1 ' 70C#7F'
cansend vcan0 000#010C
wait_for gateway 2 'state Operational'
wait_for node_again 3 ' 48C#'
stop_recording
kill -USR1 $gateway
wait_for gateway 1 ' 3172 SErrCanBus2  *1$'
wait_for gateway 1 ' 12405 CanOpOnline  *1$'
kill $gateway
wait $gateway
say "gateway ended with $?"
finish
