# Engines as figures and tables name them: without what all of them have in common.
s#ours:auto/##g
s#/concurrent##g
s#ours:auto#ODE_MT#g
s#\bstock\b#libode8#g
s#ours:0#one-thread#g
