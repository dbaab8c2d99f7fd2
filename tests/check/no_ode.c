/* A program without ODE. */
int main(void) { return 0; }
