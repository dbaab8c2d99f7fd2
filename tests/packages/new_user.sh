# Commands of docs/start.md, on a fresh Debian 12, in a folder with the packages and pile.py; system_steps.sh runs them.

# [try]
apt-get install -y python3-pyode             # a program that is not recompiled, with Debian's libode8
time python3 pile.py 1000 200
apt-get install -y ./libode8-mt_*.deb        # replaces Debian's libode8
time ODE_MT_THREADS=auto python3 pile.py 1000 200
# [try]
