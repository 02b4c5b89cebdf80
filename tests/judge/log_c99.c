/* A run as a C program writes it: gjkscope_log.h in C99. */

#include "judge/gjkscope_log.h"

void gjkscope_write_c99_log(FILE* file, double distance);

void gjkscope_write_c99_log(FILE* file, double distance) {
  static const double a[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  gjkscope_log log;
  int i;
  gjkscope_log_begin(&log, file, 3, GJKSCOPE_A_MINUS_B, "float");
  for (i = 0; i < 3; ++i) gjkscope_log_vertex(&log, "a", a[i][0], a[i][1], a[i][2]);
  gjkscope_log_vertex(&log, "b", 0.25, 0.25, 2);
  gjkscope_log_iteration(&log);
  for (i = 0; i < 3; ++i) gjkscope_log_pair(&log, "simplex", i, 0);
  for (i = 0; i < 3; ++i)
    gjkscope_log_point(&log, "points", a[i][0] - 0.25, a[i][1] - 0.25, a[i][2] - 2);
  gjkscope_log_weight(&log, 0.5);
  gjkscope_log_weight(&log, 0.25);
  gjkscope_log_weight(&log, 0.25);
  gjkscope_log_vector(&log, "closest", 0, 0, -2);
  gjkscope_log_vector(&log, "direction", 0, 0, 2);
  gjkscope_log_support(&log, 0, 0);
  gjkscope_log_answer(&log);
  gjkscope_log_number(&log, "distance", distance);
  gjkscope_log_overlap(&log, 0);
  gjkscope_log_vector(&log, "a", 0.25, 0.25, 0);
  gjkscope_log_vector(&log, "b", 0.25, 0.25, 2);
  gjkscope_log_end(&log);
}
