# A command of docs/programs.md, in this folder. run_pile.sh puts our folder in the place of /opt/ode_mt/lib, and fewer boxes and rounds in.

# [alternate]
./alternate.py /opt/ode_mt/lib auto 9 /usr/bin/python3 pile.py 1000 200
# [alternate]
