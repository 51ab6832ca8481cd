/* What stands for sqrt and fabs: Frama-C's own complain of what is not finite. */
double eva_sqrt(double x);
double eva_fabs(double x);
