// The steps of the slider between few cones and little distortion.

export const ways = ['few', 'fewer', 'balanced', 'more', 'low-distortion'] as const;
export const coneSteps = ways.length;
export const fewStep = ways.indexOf('few');
export const balancedStep = ways.indexOf('balanced');
