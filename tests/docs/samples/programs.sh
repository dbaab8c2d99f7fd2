# Commands of docs/start.md, in this folder. run_pile.sh and run_dart.sh put our folder in the place of /opt/ode_mt/lib, and less work in.

# [alternate]
./alternate.py /opt/ode_mt/lib auto 9 /usr/bin/python3 pile.py 1000 200
# [alternate]

# [dart]
./alternate.py /opt/ode_mt/lib auto 9 /usr/bin/python3 dart_pile.py 12 600
# [dart]
