/* SPDX-License-Identifier: MIT
 *
 * Inputs that are meant to take long.  Beside the corpus, with which they make one
 * program: what its functions took at most is held against their static bounds
 * (tools/wcet.py).
 */
#ifndef WCET_WORST_H
#define WCET_WORST_H

void worst_frames(void);  /* adversarial frames, through the labeller and the eye */
void worst_colours(void); /* lines of colours that are hard to decide, whole and with tails */
void worst_fits(void);    /* the most points that there may be */

#endif
