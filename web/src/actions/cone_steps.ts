// The steps of the slider between few cones and little distortion.

/** The ends and the middle are the solver's criteria; the steps between have intermediate numbers of cones. */
export const ways = ['few', undefined, 'balanced', undefined, 'low-distortion'] as const;
export const coneSteps = ways.length;
export const fewStep = ways.indexOf('few');
export const balancedStep = ways.indexOf('balanced');
